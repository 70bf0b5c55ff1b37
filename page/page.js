// What moves on the page: sorting tables, the contents list, and the Plotly plots with their filters.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const byId = (id) => document.getElementById(id);
  const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const colours = ["plot-1", "plot-2", "plot-3", "plot-4", "plot-schlick"];

  // ---- tables ------------------------------------------------------------------------------------------------------

  const number = (cell) => parseFloat(cell.dataset.value ?? cell.textContent.replaceAll(",", ""));

  function sort(table, column, direction) {
    const rows = [...table.tBodies[0].rows];
    const compare = (a, b) => {
      const x = number(a.cells[column]), y = number(b.cells[column]);
      if (!Number.isNaN(x) && !Number.isNaN(y)) return direction * (x - y);
      if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1; // unknown values last
      return direction * a.cells[column].textContent.localeCompare(b.cells[column].textContent);
    };
    table.tBodies[0].append(...rows.sort(compare));
    [...table.tHead.rows[0].cells].forEach((cell, i) => {
      cell.setAttribute("aria-sort", i !== column ? "none" : direction > 0 ? "ascending" : "descending");
    });
  }

  for (const table of document.querySelectorAll("table")) {
    const heads = [...table.tHead.rows[0].cells];
    for (const row of table.tBodies[0].rows) {
      [...row.cells].forEach((cell, i) => { cell.dataset.label = heads[i].textContent; });
    }
    if (!table.classList.contains("sortable")) continue;
    heads.forEach((head, i) => {
      head.setAttribute("aria-sort", "none");
      head.tabIndex = 0;
      const turn = () => sort(table, i, head.getAttribute("aria-sort") === "ascending" ? -1 : 1);
      head.addEventListener("click", turn);
      head.addEventListener("keydown", (event) => { if (event.key === "Enter") turn(); });
    });
  }

  // ---- contents ----------------------------------------------------------------------------------------------------

  const links = [...document.querySelectorAll("nav a")];
  function mark() {
    const atEnd = window.innerHeight + window.scrollY >= document.body.scrollHeight - 2;
    const passed = links.filter((link) => document.querySelector(link.hash).getBoundingClientRect().top < window.innerHeight / 4);
    const here = atEnd ? links[links.length - 1] : passed[passed.length - 1] ?? links[0];
    if (here.classList.contains("here")) return;
    for (const link of links) link.classList.toggle("here", link === here);
    here.parentElement.scrollLeft = here.offsetLeft - 20;
  }
  window.addEventListener("scroll", mark, { passive: true });
  mark();

  // ---- plots -------------------------------------------------------------------------------------------------------

  const settings = { responsive: true, displayModeBar: false }; // a drag zooms, a double click goes back
  const powers = [...Array(16).keys()].map((i) => 10 ** (i - 8));

  function layout(x, y, more) {
    const axis = { gridcolor: style("plot-grid"), linecolor: style("plot-axis"), zeroline: false, type: "log",
      exponentformat: "power", dtick: 1 };
    const steps = powers.flatMap((power) => window.innerWidth < 600 ? [power, 3 * power] : [power, 2 * power, 5 * power]);
    const xTics = { tickvals: steps, ticktext: steps.map((x) => String(parseFloat(x.toPrecision(1)))) };
    return { margin: { l: 62, r: 8, t: 8, b: 48 }, paper_bgcolor: "transparent", plot_bgcolor: "transparent",
      font: { family: "system-ui, sans-serif", size: 13, color: style("plot-text") }, hovermode: "closest",
      hoverlabel: { bgcolor: style("soft"), bordercolor: style("plot-axis"), align: "left",
        font: { color: style("text"), size: 12 } },
      legend: { orientation: "h", y: 1.02, yanchor: "bottom" },
      xaxis: { ...axis, ...xTics, title: { text: x } }, yaxis: { ...axis, title: { text: y } }, ...more };
  }

  const draw = [];
  function drawAll() { for (const each of draw) each(); }

  // Which unit to take: one state of the filters for the plot and the table.
  if (byId("pareto")) {
    const units = data.units.rows.map((row, id) => ({ id, ...Object.fromEntries(row.map((x, i) => [data.units.keys[i], x])) }));
    const short = (x) => String(Number(x.toPrecision(3)));
    for (const unit of units) {
      const clock = unit.clock_mhz && ` = ${short(unit.latency_ns)} ns at ${short(unit.clock_mhz)} MHz, ` +
        `${short(unit.ns_per_result)} ns a result`;
      unit.text = `<b>${unit.lobe} ${unit.profile} ${unit.architecture}</b> on ${unit.device}, ` +
        `${unit.dsp ? "DSPs allowed" : "without DSPs"}<br>error ${short(unit.error)}<br>${unit.luts} LUTs, ` +
        `${unit.registers} registers, ${unit.dsps} DSPs, ${unit.brams} BRAMs<br>latency ${unit.latency_clocks} clocks${clock || ""}`;
    }
    const rows = [...byId("units").tBodies[0].rows];
    const rowOf = new Map(rows.map((row) => [Number(row.dataset.unit), row]));
    const axes = { luts: "LUTs", latency_ns: "latency, ns", latency_clocks: "latency, clocks", ns_per_result: "ns a result" };
    const filter = (id) => byId(`filter-${id}`).value;

    const shown = () => units.filter((unit) =>
      unit.device === filter("device") && (!filter("profile") || unit.profile === filter("profile")) &&
      (!filter("lobe") || unit.lobe === filter("lobe")) &&
      (!filter("dsps") || (filter("dsps") === "none") === (unit.dsps === 0)));

    // Best first: no other has both a smaller price and a smaller error.
    const front = (list, axis) => {
      const out = [];
      for (const unit of [...list].sort((a, b) => a[axis] - b[axis] || a.error - b.error)) {
        if (!out.length || unit.error < out[out.length - 1].error) out.push(unit);
      }
      return out;
    };

    const choose = (unit) => {
      for (const [i, row] of rowOf) row.classList.toggle("chosen", i === unit.id);
      rowOf.get(unit.id).scrollIntoView({ block: "nearest" });
      byId("chosen").innerHTML = unit.text + (unit.emit ? `<br><code>${unit.emit}</code>` : "");
    };

    const update = () => {
      const axis = filter("axis");
      const list = shown();
      const visible = new Set(list.filter((unit) => filter("show") === "all" || !unit.dominated).map((unit) => unit.id));
      for (const [i, row] of rowOf) row.hidden = !visible.has(i);
      byId("count").textContent = `${visible.size} of ${list.length} units`;
      const priced = list.filter((unit) => unit[axis] > 0 && unit.error > 0);
      const best = front(priced, axis);
      const traces = [{ x: best.map((unit) => unit[axis]), y: best.map((unit) => unit.error), mode: "lines", hoverinfo: "skip",
        line: { color: style("plot-axis"), shape: "hv", width: 2 }, name: "best for its price" }];
      ["p8", "p12", "p16", "custom"].forEach((profile, i) => {
        const own = priced.filter((unit) => (["p8", "p12", "p16"].includes(unit.profile) ? unit.profile : "custom") === profile);
        if (!own.length) return;
        traces.push({ x: own.map((unit) => unit[axis]), y: own.map((unit) => unit.error), mode: "markers", name: profile,
          customdata: own.map((unit) => unit.id),
          text: own.map((unit) => unit.text + (unit.emit ? `<br>${unit.emit}` : "")), hovertemplate: "%{text}<extra></extra>",
          marker: { size: 9, color: style(colours[i]), symbol: i === 3 ? "circle-open" : "circle",
            opacity: own.map((unit) => unit.dominated ? 0.45 : 1) } });
      });
      if (axis === "ns_per_result" && data.software.length) {
        traces.push({ x: data.software.map((point) => point.ns), y: data.software.map((point) => point.error), mode: "markers",
          text: data.software.map((point) => point.text), hovertemplate: "%{text}<extra></extra>", name: "on a CPU",
          marker: { size: 8, color: style("plot-schlick"), symbol: "x-thin-open" } });
      }
      Plotly.react("pareto", traces, layout(axes[axis], "largest absolute error against cⁿ"), settings);
    };
    for (const select of document.querySelectorAll(".filters select")) select.addEventListener("change", update);
    for (const [i, row] of rowOf) row.addEventListener("click", () => choose(units[i]));
    draw.push(update);
    update();
    byId("pareto").on("plotly_click", (event) => {
      const id = event.points[0].customdata;
      if (id !== undefined) choose(units[id]);
    });
    sort(byId("units"), [...byId("units").tHead.rows[0].cells].findIndex((cell) => cell.textContent === "error"), 1);
  }

  // Errors over n: all measured runs; those of the first lobe are shown, the legend brings the others.
  function overN(id, values, label, reference) {
    if (!byId(id)) return;
    const update = () => {
      const first = data.runs[0].lobe;
      const old = byId(id).data;
      const traces = data.runs.map((run, i) => ({ x: run.n, y: run[values()], name: run.name, mode: run.n.length < 50 ?
        "lines+markers" : "lines", line: { color: style(colours[i % colours.length]), width: 1.5,
        dash: i % 10 < colours.length ? "solid" : "dot" },
        visible: old ? old[i].visible : run.lobe === first || "legendonly",
        hovertemplate: `${run.name}, n = %{x}: %{y:.4g}<extra></extra>` }));
      traces.push({ ...reference, mode: "lines", line: { color: style("plot-schlick"), dash: "dash", width: 2 },
        hovertemplate: `${reference.name}, n = %{x}: %{y:.4g}<extra></extra>` });
      const plain = layout("specular exponent n", label);
      if (id === "rounding-plot") Object.assign(plain.yaxis, { type: "linear", dtick: undefined });
      Plotly.react(id, traces, plain, settings);
    };
    draw.push(update);
    update();
  }
  if (data.runs.length) {
    const cosine = byId("cosine");
    overN("approximation-plot", () => cosine.value, "largest absolute error against cⁿ",
      { x: data.schlick.n, y: data.schlick.error, name: "f_s, Schlick, in double" });
    overN("rounding-plot", () => "rounding", "largest rounding error, ulp", { x: [1, 1023], y: [1, 1], name: "1 ulp" });
    cosine.addEventListener("change", drawAll);
  }

  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawAll);
})();
