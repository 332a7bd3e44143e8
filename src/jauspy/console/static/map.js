// The 2-D map of the tab World: cells, track, robot, and waypoints by click and drag. x points to the right, y upwards.
"use strict";

jauspy.map = {
  scale: 45,
  centre: [0, 0],
  pointers: new Map(),
  dragged: null,

  forget() {
    Object.assign(jauspy.map, { centre: [0, 0], dragged: null });
  },
  watchSize() {
    const place = document.getElementById("world-map");
    const map = jauspy.map;
    if (!place) return;
    if (!map.canvas || map.canvas.parentElement !== place) {
      map.canvas = jauspy.make("canvas", { role: "img", "aria-label": jauspy._("map: a click sets a waypoint, a drag moves one or the map") });
      place.prepend(map.canvas);
      map.listen();
    }
    const ratio = Math.min(2, devicePixelRatio);
    const [width, height] = [Math.round(place.clientWidth * ratio), Math.round(place.clientHeight * ratio)];
    const dark = document.body.classList.contains("body--dark");
    if (width && (map.canvas.width !== width || map.canvas.height !== height || map.dark !== dark)) {
      [map.canvas.width, map.canvas.height, map.ratio, map.dark] = [width, height, ratio, dark];
      map.draw();
    }
  },

  // --- between metres of the local frame and pixels of the canvas -------------------------------------------------
  toScreen([x, y]) {
    const { canvas, centre, scale, ratio } = jauspy.map;
    return [canvas.width / 2 + (x - centre[0]) * scale * ratio, canvas.height / 2 - (y - centre[1]) * scale * ratio];
  },
  toLocal(event) {
    const { canvas, centre, scale } = jauspy.map;
    const box = canvas.getBoundingClientRect();
    return [centre[0] + (event.clientX - box.left - box.width / 2) / scale, centre[1] - (event.clientY - box.top - box.height / 2) / scale];
  },
  zoom(factor, at) {
    const map = jauspy.map;
    const scale = Math.max(4, Math.min(400, map.scale * factor));
    if (at && !jauspy.world.show.follow) map.centre = [0, 1].map((axis) => at[axis] + ((map.centre[axis] - at[axis]) * map.scale) / scale);
    map.scale = scale;
    jauspy.world.changed();
  },

  // --- pointer: a click sets a waypoint, a waypoint is dragged, anything else is panned -----------------------------
  listen() {
    const map = jauspy.map;
    const { canvas } = map;
    canvas.addEventListener("wheel", (event) => { event.preventDefault(); map.zoom(Math.exp(-event.deltaY / 500), map.toLocal(event)); }, { passive: false });
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      canvas.setPointerCapture(event.pointerId);
      map.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      map.start = { at: [event.clientX, event.clientY], centre: map.centre, moved: map.pointers.size > 1 };
      map.dragged = map.pointers.size === 1 ? map.waypointAt(event) : null;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!map.pointers.has(event.pointerId)) { canvas.style.cursor = map.waypointAt(event) === null ? "crosshair" : "grab"; return; }
      const before = [...map.pointers.values()];
      map.pointers.set(event.pointerId, [event.clientX, event.clientY]);
      if (map.pointers.size === 2) {
        const apart = ([one, two]) => Math.hypot(one[0] - two[0], one[1] - two[1]);
        map.zoom(apart([...map.pointers.values()]) / Math.max(1, apart(before)));
        return;
      }
      const [x, y] = [event.clientX - map.start.at[0], event.clientY - map.start.at[1]];
      if (!map.start.moved && Math.hypot(x, y) < 5) return;
      map.start.moved = true;
      if (map.dragged !== null) map.place = map.toLocal(event);
      else {
        map.follow(false);
        map.centre = [map.start.centre[0] - x / map.scale, map.start.centre[1] + y / map.scale];
      }
      jauspy.world.changed();
    });
    const end = (event) => {
      if (!map.pointers.delete(event.pointerId) || map.pointers.size) return;
      const [x, y] = map.toLocal(event);
      if (event.type === "pointerup" && map.dragged !== null && map.start.moved) emitEvent("waypoint", { what: "move", index: map.dragged, x, y });
      else if (event.type === "pointerup" && map.dragged === null && !map.start.moved) emitEvent("waypoint", { what: jauspy.mission.drawing ? "corner" : "add", x, y });
      [map.dragged, map.place] = [null, null];
      jauspy.world.changed();
    };
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, end);
  },
  follow(on) {
    if (jauspy.world.show.follow !== on) emitEvent("world_follow", on);
    jauspy.world.show.follow = on;
  },
  waypointAt(event) {
    const { canvas, ratio } = jauspy.map;
    const box = canvas.getBoundingClientRect();
    const near = jauspy.world.waypoints.findIndex(({ x, y }) => {
      const [left, top] = jauspy.map.toScreen([x, y]);
      return Math.hypot(left / ratio - (event.clientX - box.left), top / ratio - (event.clientY - box.top)) < 14;
    });
    return near < 0 ? null : near;
  },

  // --- drawing --------------------------------------------------------------------------------------------------
  draw() {
    const map = jauspy.map;
    const world = jauspy.world;
    const place = document.getElementById("world-map");
    if (!map.canvas?.width || !place || place.offsetParent === null) return;
    if (world.show.follow && world.pose && map.dragged === null) map.centre = [world.pose[0], world.pose[1]];
    const pen = map.canvas.getContext("2d");
    const colours = world.colours();
    const unit = map.scale * map.ratio;
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.fillStyle = colours.ground;
    pen.fillRect(0, 0, map.canvas.width, map.canvas.height);
    jauspy.mission.drawTiles(pen);
    if (world.map) map.drawCells(pen, unit);
    jauspy.way.drawCosts(pen, unit);
    map.drawGrid(pen, colours, unit);
    if (world.show.scan && world.scan && world.pose) map.drawScan(pen, colours);
    map.drawLine(pen, world.track, colours.track, 2);
    jauspy.way.drawPath(pen, colours);
    jauspy.mission.drawAreas(pen);
    map.drawRoute(pen, colours);
    jauspy.mission.drawOthers(pen, colours);
    if (world.pose) map.drawRobot(pen, colours);
    map.drawScale(pen, colours, unit);
    jauspy.mission.drawAttribution(pen);
  },
  drawCells(pen, unit) {
    const { map: cells, drift } = jauspy.world;
    pen.save();
    pen.translate(...jauspy.map.toScreen(drift));
    pen.rotate(-drift[2]);
    pen.imageSmoothingEnabled = false;
    if (jauspy.mission.tiles && jauspy.world.geo) pen.globalAlpha = 0.5; // the offline map shows through
    const side = cells.side * unit;
    pen.drawImage(jauspy.world.picture(cells), cells.x * unit, -(cells.y * unit + cells.rows * side), cells.columns * side, cells.rows * side);
    pen.restore();
  },
  drawGrid(pen, colours, unit) {
    const map = jauspy.map;
    const step = [0.5, 1, 2, 5, 10, 20, 50].find((each) => each * unit > 38 * map.ratio) ?? 100;
    const [low, high] = [[-1, -1], [1, 1]].map((to) => [0, 1].map((axis) => map.centre[axis] + (to[axis] * [map.canvas.width, map.canvas.height][axis]) / 2 / unit));
    pen.lineWidth = map.ratio;
    pen.strokeStyle = colours.line;
    pen.globalAlpha = 0.75;
    pen.beginPath();
    for (let x = Math.ceil(low[0] / step) * step; x <= high[0]; x += step) { const [at] = map.toScreen([x, 0]); pen.moveTo(Math.round(at) + 0.5, 0); pen.lineTo(Math.round(at) + 0.5, map.canvas.height); }
    for (let y = Math.ceil(low[1] / step) * step; y <= high[1]; y += step) { const [, at] = map.toScreen([0, y]); pen.moveTo(0, Math.round(at) + 0.5); pen.lineTo(map.canvas.width, Math.round(at) + 0.5); }
    pen.stroke();
    pen.globalAlpha = 1;
    const [x, y] = map.toScreen([0, 0]);
    for (const [colour, right, up] of [["#d84a4a", 16, 0], ["#3fa35b", 0, 16]]) {
      pen.strokeStyle = colour;
      pen.lineWidth = 2 * map.ratio;
      pen.beginPath();
      pen.moveTo(x, y);
      pen.lineTo(x + right * map.ratio, y - up * map.ratio);
      pen.stroke();
    }
  },
  drawScan(pen, colours) {
    const [x, y, , , , yaw] = jauspy.world.pose;
    const { points } = jauspy.world.scan;
    const [c, s] = [Math.cos(yaw) / 100, Math.sin(yaw) / 100];
    const size = 2 * jauspy.map.ratio;
    pen.fillStyle = colours.scan;
    for (let at = 0; at < points.length; at += 2) {
      const [left, top] = jauspy.map.toScreen([x + c * points[at] - s * points[at + 1], y + s * points[at] + c * points[at + 1]]);
      pen.fillRect(left - size / 2, top - size / 2, size, size);
    }
  },
  drawLine(pen, points, colour, width, dash = []) {
    if (points.length < 2) return;
    pen.strokeStyle = colour;
    pen.lineWidth = width * jauspy.map.ratio;
    pen.lineJoin = "round";
    pen.setLineDash(dash.map((each) => each * jauspy.map.ratio));
    pen.beginPath();
    for (const point of points) pen.lineTo(...jauspy.map.toScreen(point));
    pen.stroke();
    pen.setLineDash([]);
  },
  drawRoute(pen, colours) {
    const map = jauspy.map;
    const points = jauspy.world.waypoints.map((each, index) => (index === map.dragged && map.place ? { ...each, x: map.place[0], y: map.place[1] } : each));
    const active = points.findIndex((each) => each.state === "active");
    map.drawLine(pen, points.map(({ x, y }) => [x, y]), colours.route, 1.5, points.some((each) => each.state === "not sent") ? [5, 5] : []);
    if (active >= 0 && jauspy.world.pose) map.drawLine(pen, [jauspy.world.pose.slice(0, 2), [points[active].x, points[active].y]], colours.route, 3);
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.font = `600 ${11 * map.ratio}px system-ui, sans-serif`;
    points.forEach(({ x, y, state }, index) => {
      const [left, top] = map.toScreen([x, y]);
      const filled = state !== "not sent";
      pen.beginPath();
      pen.arc(left, top, 10 * map.ratio, 0, 2 * Math.PI);
      pen.fillStyle = state === "reached" ? colours.done : filled ? colours.route : colours.panel;
      pen.fill();
      pen.lineWidth = 2 * map.ratio;
      pen.strokeStyle = filled ? colours.panel : colours.route;
      pen.stroke();
      if (state === "active") { pen.beginPath(); pen.arc(left, top, 14 * map.ratio, 0, 2 * Math.PI); pen.strokeStyle = colours.route; pen.stroke(); }
      pen.fillStyle = filled ? "#ffffff" : colours.text;
      pen.fillText(`${index + 1}`, left, top + 0.5);
    });
  },
  drawRobot(pen, colours) {
    const map = jauspy.map;
    const [x, y, , , , yaw] = jauspy.world.pose;
    const size = Math.max(11 * map.ratio, 0.4 * map.scale * map.ratio);
    pen.save();
    pen.translate(...map.toScreen([x, y]));
    pen.rotate(-yaw);
    pen.beginPath();
    for (const [ahead, left] of [[1, 0], [-0.75, 0.68], [-0.4, 0], [-0.75, -0.68]]) pen.lineTo(ahead * size, -left * size);
    pen.closePath();
    pen.fillStyle = colours.accent;
    pen.fill();
    pen.lineWidth = 2 * map.ratio;
    pen.strokeStyle = colours.panel;
    pen.stroke();
    pen.restore();
  },
  drawScale(pen, colours, unit) {
    const map = jauspy.map;
    const { metres: length, text } = jauspy.settings.scaleBar((50 * map.ratio) / unit);
    const [x, y] = [12 * map.ratio, map.canvas.height - 12 * map.ratio];
    pen.strokeStyle = pen.fillStyle = colours.text;
    pen.lineWidth = 1.5 * map.ratio;
    pen.beginPath();
    for (const [right, up] of [[0, 5], [0, 0], [length * unit, 0], [length * unit, 5]]) pen.lineTo(x + right, y - up * map.ratio);
    pen.stroke();
    pen.textAlign = "left";
    pen.textBaseline = "bottom";
    pen.font = `${11 * map.ratio}px system-ui, sans-serif`;
    pen.fillText(text, x + 4 * map.ratio, y - 5 * map.ratio);
  },
};
