// The chart of the tab Plots: the browser keeps the values, the server sends those that are new.
"use strict";

jauspy.MAX_SAMPLES = 6000;
jauspy.charts = new Map();
// Colours that the colour-blind can tell apart (Okabe and Ito); traces beyond them are dashed.
jauspy.colours = { light: ["#0072b2", "#d55e00", "#009e73", "#b3589a", "#b07a00", "#3a9bd1"], dark: ["#56b4e9", "#ff8a3d", "#2fc79a", "#e08fc2", "#e6b93c", "#9fd3f5"] };

jauspy.plot = (id, traces, span, paused) => {
  const values = jauspy.charts.get(id) ?? new Map();
  jauspy.charts.set(id, values);
  const present = new Set(traces.map((trace) => trace.number));
  for (const number of values.keys()) if (!present.has(number)) values.delete(number);
  for (const { number, points } of traces) {
    const kept = values.get(number) ?? [];
    kept.push(...points);
    if (kept.length > jauspy.MAX_SAMPLES) kept.splice(0, kept.length - jauspy.MAX_SAMPLES);
    values.set(number, kept);
  }
  const chart = getElement(id)?.chart;
  if (!chart || paused) return;
  const style = getComputedStyle(document.body);
  const colour = (name) => style.getPropertyValue(`--${name}`).trim();
  const palette = jauspy.colours[document.body.classList.contains("body--dark") ? "dark" : "light"];
  const units = [...new Set(traces.map((trace) => trace.unit))];
  const newest = Math.max(0, ...[...values.values()].map((kept) => kept.at(-1)?.[0] ?? 0));
  const axis = { axisLabel: { color: colour("quiet"), hideOverlap: true }, axisLine: { lineStyle: { color: colour("line") } }, splitLine: { lineStyle: { color: colour("line"), opacity: 0.6 } } };
  const right = Math.ceil((units.length - 1) / 2);
  const left = Math.max(1, units.length - right);
  chart.setOption({
    animation: false,
    grid: { left: 8 + 50 * left, right: 16 + 50 * right, top: 34, bottom: 74 },
    tooltip: { trigger: "axis", backgroundColor: colour("panel"), borderColor: colour("line"), textStyle: { color: colour("text"), fontSize: 12 }, valueFormatter: (value) => Number(value).toPrecision(5) },
    xAxis: { type: "time", min: span && newest ? newest - 1000 * span : null, max: newest || null, ...axis, splitLine: { show: false } },
    yAxis: (units.length ? units : [""]).map((unit, place) => ({
      type: "value", scale: true, name: unit, nameTextStyle: { color: colour("quiet") }, ...axis,
      position: place % 2 ? "right" : "left", offset: 50 * Math.floor(place / 2), splitLine: { ...axis.splitLine, show: place === 0 },
    })),
    dataZoom: [{ type: "inside", filterMode: "none" }, { type: "slider", filterMode: "none", height: 20, bottom: 12, borderColor: colour("line"), textStyle: { color: colour("quiet") }, brushSelect: false }],
    series: traces.map((trace, place) => ({
      id: `${trace.number}`, name: trace.name, type: "line", showSymbol: false, data: values.get(trace.number),
      yAxisIndex: units.indexOf(trace.unit), color: palette[place % palette.length],
      lineStyle: { width: 1.6, type: place < palette.length ? "solid" : "dashed" },
    })),
  }, { replaceMerge: ["series", "yAxis"] });
};
jauspy.clearPlot = (id) => jauspy.charts.delete(id);
