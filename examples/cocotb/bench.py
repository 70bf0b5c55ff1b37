"""cocotb benches of a lobe's units: random back-pressure, the Python golden model as reference. run.py starts them.

What is random comes from cocotb's seed, which is printed: run.py --seed repeats a run.
"""

import os
import random

import cocotb
import glint
import numpy as np
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, RisingEdge, with_timeout
from cocotbext.axi import AxiStreamBus, AxiStreamFrame, AxiStreamSink, AxiStreamSource

LOBE = glint.lobe(os.environ["GLINT_LOBE"], os.environ["GLINT_PROFILE"])
COUNT = int(os.environ["GLINT_COUNT"])
PATIENCE = 20000  # ns without a result, after which none is expected any more: 2000 clocks


def pauses():
    """When a side rests, clock by clock: never, at times, mostly, in turns."""
    while True:
        chance = random.choice((0, 0.1, 0.5, 0.95))
        for _ in range(random.randrange(1, 100)):
            yield random.random() < chance


def inputs():
    """Corners first, then random ones: what the ports can carry, one in eight illegal. And what the golden model says."""
    vectors = LOBE.vectors(COUNT, cocotb.RANDOM_SEED % 2**31)
    y, clamped = glint.unpack(LOBE.port(vectors.n, vectors.cos_code))
    return vectors.n.tolist(), vectors.cos_code.tolist(), y.tolist(), clamped.tolist()


async def reset(clock, reset_n):
    cocotb.start_soon(Clock(clock, 10, "ns").start())
    reset_n.value = 0
    await ClockCycles(clock, 3)
    reset_n.value = 1


class Checker:
    """Holds results against what is expected, in order."""

    def __init__(self, expected):
        self.expected = expected
        self.compared = self.mismatches = 0

    def take(self, result):
        assert self.compared < len(self.expected), f"a result that no input had asked for: {result}"
        if result != self.expected[self.compared]:
            self.mismatches += 1
            cocotb.log.error("result %d is %s; expected %s", self.compared, result, self.expected[self.compared])
        self.compared += 1
        assert self.mismatches < 10, "ten mismatches"

    def end(self):
        cocotb.log.info("%d results, %d mismatches, seed %d", self.compared, self.mismatches, cocotb.RANDOM_SEED)
        assert self.compared == COUNT > 0 and self.mismatches == 0


@cocotb.test()
async def core_stream(dut):
    """The core unit: glint_bps_p12."""
    dut.valid_i.value = dut.ready_i.value = 0
    await reset(dut.clk_i, dut.rst_ni)
    n, cos, y, clamped = inputs()
    tag_mask = 2 ** len(dut.tag_i) - 1
    checker = Checker([(y[i], clamped[i], i & tag_mask) for i in range(COUNT)])

    async def send():
        resting = pauses()
        for i in range(COUNT):
            while next(resting):
                dut.valid_i.value = 0
                await RisingEdge(dut.clk_i)
            dut.valid_i.value = 1
            dut.n_i.value, dut.cos_i.value, dut.tag_i.value = n[i], cos[i], i & tag_mask
            await RisingEdge(dut.clk_i)
            while not dut.ready_o.value:
                await RisingEdge(dut.clk_i)
        dut.valid_i.value = 0

    async def receive():
        resting = pauses()
        while True:
            dut.ready_i.value = not next(resting)
            await RisingEdge(dut.clk_i)
            if dut.valid_o.value and dut.ready_i.value:
                checker.take((int(dut.y_o.value), bool(dut.clamped_o.value), int(dut.tag_o.value)))

    sender = cocotb.start_soon(send())
    cocotb.start_soon(receive())
    before = -1
    while checker.compared > before:  # goes on while results come; what comes too much is an error of take
        before = checker.compared
        await ClockCycles(dut.clk_i, PATIENCE // 10)
    assert sender.done(), "not all inputs were accepted"
    checker.end()


@cocotb.test()
async def axi_stream(dut):
    """The AXI4-Stream unit, glint_bps_axis_p12: frames of random length, tuser with each word, tlast at their ends."""
    settings = {"clock": dut.aclk, "reset": dut.aresetn, "reset_active_level": False}
    source = AxiStreamSource(AxiStreamBus.from_prefix(dut, "s_axis"), **settings)
    sink = AxiStreamSink(AxiStreamBus.from_prefix(dut, "m_axis"), **settings)
    for side in (source, sink):
        side.log.setLevel("WARNING")  # not every frame
        side.set_pause_generator(pauses())
    await reset(dut.aclk, dut.aresetn)
    n, cos, y, clamped = inputs()
    user = [random.getrandbits(len(dut.s_axis_tuser)) for _ in range(COUNT)]
    checker = Checker([(y[i], clamped[i], user[i]) for i in range(COUNT)])
    ends, first = [], 0
    while first < COUNT:
        last = min(COUNT, first + random.choice((1, 2, 17, 200)))
        # A word is {cos[31:0], 22 bits that the unit ignores, n[9:0]}; a byte has the tuser of its word.
        words = [n[i] | random.getrandbits(22) << 10 | (cos[i] & 0xFFFFFFFF) << 32 for i in range(first, last)]
        await source.send(AxiStreamFrame(np.array(words, "<u8").tobytes(), tuser=np.repeat(user[first:last], 8).tolist()))
        ends.append(last)
        first = last
    for end in ends:
        before = checker.compared
        frame = await with_timeout(sink.recv(compact=False), PATIENCE * 20, "ns")
        for word, tuser in zip(np.frombuffer(bytes(frame.tdata), "<u4").tolist(), frame.tuser[::4]):
            checker.take((word & 0x7FFFFFFF, bool(word >> 31), tuser))
        assert checker.compared == end, f"a frame of {checker.compared - before} words; expected {end - before}"
    await ClockCycles(dut.aclk, PATIENCE // 10)
    assert sink.empty() and sink.idle(), "a result that no input had asked for"
    checker.end()
