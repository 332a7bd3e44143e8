// The views of the page: splitters, titles that are dragged, keys for presets (1 to 4) and for the full window (F).
"use strict";

jauspy.desk = {
  LEAST: 0.15, // share of the width or height that a view keeps
  dragged: null,

  keep(arrangement) {
    try {
      localStorage.setItem("jauspy-desk", arrangement);
    } catch { /* this browser keeps nothing */ }
  },
  restore() {
    if (!window.did_handshake || !document.querySelector(".desk")) { setTimeout(jauspy.desk.restore, 100); return; }
    let kept = null;
    try {
      kept = localStorage.getItem("jauspy-desk");
    } catch { /* this browser keeps nothing */ }
    if (kept) emitEvent("desk", { kept });
  },
  place: () => document.querySelector(".desk"),
  share(split) {
    return Number(getComputedStyle(jauspy.desk.place()).getPropertyValue(`--${split}`)) || 0.5;
  },
  resize(split, share, ended) {
    const kept = Math.max(jauspy.desk.LEAST, Math.min(1 - jauspy.desk.LEAST, share));
    jauspy.desk.place().style.setProperty(`--${split}`, kept.toFixed(3));
    if (ended) emitEvent("desk", { split, share: Number(kept.toFixed(3)) });
  },
  shareAt(split, event) {
    const box = jauspy.desk.place().getBoundingClientRect();
    return split === "width" ? (event.clientX - box.left) / box.width : (event.clientY - box.top) / box.height;
  },

  // One view in all of the window below the bar, which keeps STOP: in the full screen of browsers, Escape would end that
  // and stop no robot.
  toggleFull() {
    if (jauspy.desk.endFull()) return;
    const shown = [...document.querySelectorAll(".pane")].filter((pane) => pane.offsetParent !== null);
    const pane = shown.find((each) => each.dataset.view === jauspy.desk.used) ?? shown[0];
    if (!pane) return;
    pane.dataset.full = "yes";
    document.body.classList.add("full");
    jauspy.desk.closing.observe(pane, { attributes: true, attributeFilter: ["class"] });
  },
  // Shows the other views again; returns whether one had filled the window.
  endFull() {
    const full = document.querySelector(".pane[data-full]");
    if (full) delete full.dataset.full;
    document.body.classList.remove("full");
    jauspy.desk.closing.disconnect();
    return full !== null;
  },
  closing: new MutationObserver(() => { if (document.querySelector(".pane[data-full].hidden")) jauspy.desk.endFull(); }),

  listen() {
    const desk = jauspy.desk;
    document.addEventListener("pointerdown", (event) => {
      const pane = event.target.closest?.(".pane");
      if (pane && pane.dataset.view !== desk.used) {
        desk.used = pane.dataset.view;
        emitEvent("desk", { used: desk.used });
      }
      const splitter = event.target.closest?.(".splitter");
      const title = event.target.closest?.(".pane-bar");
      if (event.button !== 0 || (!splitter && (!title || event.target.closest("button")))) return;
      (splitter ?? title).setPointerCapture(event.pointerId);
      desk.dragged = { splitter, pane };
      if (!splitter) document.body.classList.add("placing");
    });
    document.addEventListener("pointermove", (event) => {
      const splitter = desk.dragged?.splitter;
      if (splitter) desk.resize(splitter.dataset.split, desk.shareAt(splitter.dataset.split, event), false);
    });
    document.addEventListener("pointerup", (event) => {
      const { splitter, pane } = desk.dragged ?? {};
      desk.stop();
      if (splitter) desk.resize(splitter.dataset.split, desk.shareAt(splitter.dataset.split, event), true);
      const to = document.elementsFromPoint(event.clientX, event.clientY).find((each) => each.matches(".pane"));
      if (!splitter && pane && to && to !== pane) emitEvent("desk", { move: pane.dataset.view, to: to.dataset.view });
    });
    document.addEventListener("pointercancel", desk.stop);
    addEventListener("keydown", (event) => {
      if (event.repeat || !jauspy.isForPage(event)) return;
      const splitter = event.target.closest?.(".splitter");
      const step = { ArrowLeft: -0.02, ArrowUp: -0.02, ArrowRight: 0.02, ArrowDown: 0.02 }[event.code];
      if (splitter && step) desk.resize(splitter.dataset.split, desk.share(splitter.dataset.split) + step, true);
      else if (/^Digit[1-4]$/.test(event.code) && !event.shiftKey) {
        desk.endFull();
        emitEvent("desk", { preset: Number(event.code.slice(5)) });
      } else if (jauspy.letter(event) === "f") desk.toggleFull();
      else return;
      event.preventDefault();
    });
  },
  stop() {
    jauspy.desk.dragged = null;
    document.body.classList.remove("placing");
  },
};
jauspy.desk.listen();
jauspy.desk.restore();
