// The pointer in the large picture: a click looks there or measures, a drag turns the camera; crosshair and mark.
"use strict";

jauspy.sight = {
  turns: false, // whether the large camera pans and tilts
  start: null,

  choose(turns) {
    jauspy.sight.turns = turns;
    jauspy.sight.hide();
  },
  // The rectangle of the picture within its frame, which it does not fill.
  picture(canvas) {
    const box = canvas.getBoundingClientRect();
    const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
    const [width, height] = [canvas.width * scale, canvas.height * scale];
    return { left: box.left + (box.width - width) / 2, top: box.top + (box.height - height) / 2, width, height, aspect: canvas.width / canvas.height, box };
  },
  canvasAt(event) {
    const figure = event.target.closest?.("figure");
    return figure && jauspy.isLarge(figure) && !event.target.closest("button") ? figure.querySelector("canvas") : null;
  },
  layer(canvas) {
    const figure = canvas.closest("figure");
    let layer = figure.querySelector(".sight");
    if (layer) return layer;
    layer = Object.assign(document.createElement("div"), { className: "sight" });
    for (const name of ["cross", "mark", "grip", "range"]) layer.append(Object.assign(document.createElement("span"), { className: name }));
    layer.querySelector(".range").setAttribute("role", "status");
    figure.append(layer);
    return layer;
  },
  show({ component, x, y, text, width }) {
    const canvas = document.querySelector(`canvas[data-component="${CSS.escape(component)}"]`);
    if (!canvas) return;
    jauspy.sight.shown = { canvas, x, y, width, until: performance.now() + 15_000 };
    const layer = jauspy.sight.layer(canvas);
    layer.querySelector(".range").textContent = text;
    layer.dataset.shown = "yes";
    jauspy.sight.place();
  },
  hide() {
    const shown = jauspy.sight.shown;
    if (shown) delete jauspy.sight.layer(shown.canvas).dataset.shown;
    jauspy.sight.shown = null;
  },
  place() {
    const shown = jauspy.sight.shown;
    if (!shown) return;
    if (performance.now() > shown.until) { jauspy.sight.hide(); return; }
    const picture = jauspy.sight.picture(shown.canvas);
    const layer = jauspy.sight.layer(shown.canvas);
    const [left, top] = [picture.left - picture.box.left + shown.x * picture.width, picture.top - picture.box.top + shown.y * picture.height];
    for (const name of ["mark", "grip", "range"]) Object.assign(layer.querySelector(`.${name}`).style, { left: `${left}px`, top: `${top}px` });
    layer.querySelector(".grip").style.width = `${shown.width * picture.width}px`;
    layer.classList.toggle("at-right", left > 0.6 * picture.box.width);
  },
  shares(canvas, event) {
    const { left, top, width, height, aspect } = jauspy.sight.picture(canvas);
    return { x: (event.clientX - left) / width, y: (event.clientY - top) / height, aspect };
  },
  listen() {
    const sight = jauspy.sight;
    document.addEventListener("pointerdown", (event) => {
      const canvas = sight.canvasAt(event);
      if (!canvas || event.button !== 0) return;
      sight.start = { canvas, at: sight.shares(canvas, event), x: event.clientX, y: event.clientY, moved: false, sent: 0 };
    });
    document.addEventListener("pointermove", (event) => {
      const { start } = sight;
      if (!start || !sight.turns) return;
      if (!start.moved && Math.hypot(event.clientX - start.x, event.clientY - start.y) < 6) return;
      const first = !start.moved;
      start.moved = true;
      if (performance.now() - start.sent < 100) return;
      start.sent = performance.now();
      sight.drag(start, event, first);
    });
    document.addEventListener("pointerup", (event) => {
      const { start } = sight;
      sight.start = null;
      if (!start) return;
      if (start.moved) setTimeout(() => sight.drag(start, event, false), 150); // where the pointer ended
      else if (sight.canvasAt(event) === start.canvas) {
        const { x, y, aspect } = start.at;
        if (x < 0 || x > 1 || y < 0 || y > 1) return;
        emitEvent("camera_pointed", { what: sight.turns && !event.shiftKey ? "look" : "measure", x, y, aspect });
      }
    });
    document.addEventListener("pointercancel", () => { sight.start = null; });
    setInterval(() => {
      for (const canvas of document.querySelectorAll("canvas[data-component]")) sight.layer(canvas);
      sight.place();
    }, 250);
  },
  drag(start, event, first) {
    const now = jauspy.sight.shares(start.canvas, event);
    emitEvent("camera_pointed", { what: "drag", x: now.x - start.at.x, y: now.y - start.at.y, aspect: now.aspect, first });
  },
};
jauspy.sight.listen();
