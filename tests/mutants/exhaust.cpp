// Runs a circuit of gates on every input, 1024 inputs at a time, with each of its planted faults beside it. exhaust.py
// writes the circuit: "inputs N random R gates G faults F", a line a gate "op a b c", the outputs, and for each fault
// its number, its gates "op a b c to" and the outputs that it may change. Node 0 is 0, node 1 is 1, then the inputs,
// then the gates. Prints a line a fault: its number, and the first input that tells it, or "none".

#include <cstdint>
#include <iostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using Lanes = std::uint64_t __attribute__((vector_size(64)));
constexpr int words = 2;
struct Node {
    Lanes lanes[words];
};
struct Gate {
    char op;
    int a, b, c, to;
};
struct Fault {
    int number;
    std::vector<Gate> gates;
    std::vector<std::pair<int, int>> outputs;
    std::string found = "none";
};

template <class Operation>
void each(Node& out, Operation operation) {
    for (int i = 0; i < words; ++i) operation(out.lanes[i], i);
}

void evaluate(const std::vector<Gate>& gates, Node* nodes) {
    for (const Gate& gate : gates) {
        const Node &a = nodes[gate.a], &b = nodes[gate.b], &c = nodes[gate.c];
        Node& out = nodes[gate.to];
        switch (gate.op) {
            case '&':
                each(out, [&](Lanes& to, int i) { to = a.lanes[i] & b.lanes[i]; });
                break;
            case '|':
                each(out, [&](Lanes& to, int i) { to = a.lanes[i] | b.lanes[i]; });
                break;
            case '^':
                each(out, [&](Lanes& to, int i) { to = a.lanes[i] ^ b.lanes[i]; });
                break;
            case 'd':
                each(out, [&](Lanes& to, int i) { to = a.lanes[i] & ~b.lanes[i]; });
                break;
            case 'o':
                each(out, [&](Lanes& to, int i) { to = a.lanes[i] | ~b.lanes[i]; });
                break;
            case '!':
                each(out, [&](Lanes& to, int i) { to = ~a.lanes[i]; });
                break;
            default:
                each(out, [&](Lanes& to, int i) { to = (c.lanes[i] & b.lanes[i]) | (~c.lanes[i] & a.lanes[i]); });
                break;
        }
    }
}

std::uint64_t* bits(Node& node) { return reinterpret_cast<std::uint64_t*>(&node); }

}  // namespace

int main() {
    std::string word;
    int inputs = 0, gate_count = 0, fault_count = 0, output_count = 0;
    std::uint64_t random = 0;
    std::cin >> word >> inputs >> word >> random >> word >> gate_count >> word >> fault_count;
    std::vector<Gate> gates(gate_count);
    int next = 2 + inputs;
    for (Gate& gate : gates) {
        std::cin >> gate.op >> gate.a >> gate.b >> gate.c;
        gate.to = next++;
    }
    std::vector<Fault> faults(fault_count);
    int last = next;
    for (Fault& fault : faults) {
        std::cin >> fault.number >> gate_count >> output_count;
        fault.gates.resize(gate_count);
        for (Gate& gate : fault.gates) {
            std::cin >> gate.op >> gate.a >> gate.b >> gate.c >> gate.to;
            last = std::max(last, gate.to + 1);
        }
        fault.outputs.resize(output_count);
        for (auto& [clean, faulty] : fault.outputs) std::cin >> clean >> faulty;
    }
    if (!std::cin) {
        std::cerr << "exhaust: the circuit is cut\n";
        return 1;
    }
    std::vector<Node> nodes(last, Node{});
    for (auto& lanes : nodes[1].lanes) lanes = ~Lanes{};
    constexpr int block_bits = 10;
    static_assert(words * 512 == 1 << block_bits);
    std::mt19937_64 engine(1);
    const std::uint64_t blocks = random != 0 ? random : std::uint64_t{1} << std::max(0, inputs - block_bits);
    for (std::uint64_t block = 0; block < blocks; ++block) {
        for (int i = 0; i < inputs; ++i) {
            std::uint64_t* lanes = bits(nodes[2 + i]);
            for (int j = 0; j < 8 * words; ++j) {
                std::uint64_t value = 0;
                for (int k = 0; k < 64 && i < 6; ++k) value |= static_cast<std::uint64_t>(k >> i & 1) << k;
                if (i >= 6 && i < block_bits) value = (j >> (i - 6) & 1) != 0 ? ~std::uint64_t{0} : 0;
                if (i >= block_bits) value = (block >> (i - block_bits) & 1) != 0 ? ~std::uint64_t{0} : 0;
                lanes[j] = random != 0 ? engine() : value;
            }
        }
        evaluate(gates, nodes.data());
        for (Fault& fault : faults) {
            if (fault.found != "none") continue;
            evaluate(fault.gates, nodes.data());
            for (const auto& [clean, faulty] : fault.outputs) {
                for (int j = 0; j < 8 * words && fault.found == "none"; ++j) {
                    const std::uint64_t differs = bits(nodes[clean])[j] ^ bits(nodes[faulty])[j];
                    if (differs == 0) continue;
                    const int lane = __builtin_ctzll(differs);
                    fault.found.clear();
                    for (int i = inputs; i-- > 0;) fault.found += (bits(nodes[2 + i])[j] >> lane & 1) != 0 ? '1' : '0';
                }
            }
        }
    }
    for (const Fault& fault : faults) std::cout << fault.number << " " << fault.found << "\n";
}
