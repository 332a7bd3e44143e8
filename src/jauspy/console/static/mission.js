// Missions on the map: tiles of an offline map, no-go areas, the other robots.
"use strict";

jauspy.mission = {
  MAX_TILES: 80, // on one map
  MAX_KEPT: 300,
  RADIUS: 6378137, // metres, WGS 84
  ECCENTRICITY: 0.00669438, // squared
  tiles: null,
  images: new Map(),
  areas: [],
  corners: [], // of the area that is being drawn
  drawing: false,

  setTiles(least, most, attribution) { jauspy.mission.tiles = { least, most, attribution }; jauspy.world.changed(); },
  setAreas(areas, corners, drawing) { Object.assign(jauspy.mission, { areas, corners, drawing }); jauspy.world.changed(); },

  // End the drawing of an area; true if one was being drawn where it is seen.
  cancelArea() {
    const { mission } = jauspy;
    if (!mission.drawing || !document.getElementById("world-map")?.offsetParent) return false;
    mission.drawing = false;
    emitEvent("area_cancelled");
    return true;
  },

  // --- between the local frame and Web Mercator as parts of the world (0..1, y downwards) -----------------------------
  toMercator([x, y]) {
    const [latitude, longitude, heading] = jauspy.world.geo;
    const { RADIUS, ECCENTRICITY } = jauspy.mission;
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    const flat = 1 - ECCENTRICITY * Math.sin(latitude) ** 2;
    const north = latitude + ((x * c + y * s) * flat ** 1.5) / (RADIUS * (1 - ECCENTRICITY));
    const east = longitude + ((x * s - y * c) * Math.sqrt(flat)) / (RADIUS * Math.cos(latitude));
    return [east / (2 * Math.PI) + 0.5, 0.5 - Math.asinh(Math.tan(north)) / (2 * Math.PI)];
  },
  toLocal([u, v]) {
    const [latitude, longitude, heading] = jauspy.world.geo;
    const { RADIUS, ECCENTRICITY } = jauspy.mission;
    const [c, s] = [Math.cos(heading), Math.sin(heading)];
    const flat = 1 - ECCENTRICITY * Math.sin(latitude) ** 2;
    const north = ((Math.atan(Math.sinh(Math.PI * (1 - 2 * v))) - latitude) * RADIUS * (1 - ECCENTRICITY)) / flat ** 1.5;
    const east = ((2 * Math.PI * (u - 0.5) - longitude) * RADIUS * Math.cos(latitude)) / Math.sqrt(flat);
    return [north * c + east * s, north * s - east * c];
  },
  drawTiles(pen) {
    const { tiles, MAX_TILES } = jauspy.mission;
    const { map, world } = jauspy;
    if (!tiles || !world.geo) return;
    const { width, height } = map.canvas;
    const across = 2 * Math.PI * jauspy.mission.RADIUS * Math.cos(world.geo[0]);
    let zoom = Math.max(tiles.least, Math.min(tiles.most, Math.round(Math.log2((across / 256) * map.scale * map.ratio))));
    const half = [width / 2, height / 2].map((each) => each / map.scale / map.ratio);
    const corners = [[-1, -1], [1, -1], [-1, 1], [1, 1]].map(([x, y]) => jauspy.mission.toMercator([map.centre[0] + x * half[0], map.centre[1] + y * half[1]]));
    const range = (axis, at) => [Math.min, Math.max].map((pick) => Math.max(0, Math.min(2 ** at - 1, Math.floor(pick(...corners.map((each) => each[axis])) * 2 ** at))));
    while (zoom > tiles.least && [0, 1].reduce((many, axis) => many * (range(axis, zoom)[1] - range(axis, zoom)[0] + 1), 1) > MAX_TILES) zoom -= 1;
    const [[left, right], [top, bottom]] = [range(0, zoom), range(1, zoom)];
    if ((right - left + 1) * (bottom - top + 1) > MAX_TILES) return;
    pen.save();
    for (let x = left; x <= right; x += 1) {
      for (let y = top; y <= bottom; y += 1) {
        const image = jauspy.mission.image(zoom, x, y);
        if (!image?.complete || !image.naturalWidth) continue;
        const at = (right, down) => map.toScreen(jauspy.mission.toLocal([(x + right) / 2 ** zoom, (y + down) / 2 ** zoom]));
        const [origin, aside, below] = [at(0, 0), at(1, 0), at(0, 1)];
        const size = image.naturalWidth;
        pen.setTransform((aside[0] - origin[0]) / size, (aside[1] - origin[1]) / size, (below[0] - origin[0]) / size, (below[1] - origin[1]) / size, ...origin);
        pen.drawImage(image, 0, 0, size + 0.5, size + 0.5);
      }
    }
    pen.restore();
  },
  drawAttribution(pen) {
    const { tiles } = jauspy.mission;
    const { map, world } = jauspy;
    if (!tiles?.attribution || !world.geo) return;
    pen.font = `${10 * map.ratio}px system-ui, sans-serif`;
    pen.textAlign = "right";
    pen.textBaseline = "bottom";
    pen.fillStyle = world.colours().text;
    pen.fillText(tiles.attribution, map.canvas.width - 6 * map.ratio, map.canvas.height - 4 * map.ratio);
  },
  image(zoom, x, y) {
    const { images, MAX_KEPT } = jauspy.mission;
    const key = `${zoom}/${x}/${y}`;
    if (!images.has(key)) {
      const image = new Image();
      image.onload = () => jauspy.world.changed();
      image.src = `/tiles/${jauspy.token}/${key}`;
      images.set(key, image);
      if (images.size > MAX_KEPT) images.delete(images.keys().next().value);
    }
    return images.get(key);
  },

  drawAreas(pen) {
    const { map, mission } = jauspy;
    const dark = document.body.classList.contains("body--dark");
    const red = dark ? "#ff6b6b" : "#c62828";
    const line = (points, close) => {
      pen.beginPath();
      for (const point of points) pen.lineTo(...map.toScreen(point));
      if (close) pen.closePath();
      pen.stroke();
    };
    pen.save();
    pen.strokeStyle = pen.fillStyle = red;
    pen.lineWidth = 2 * map.ratio;
    pen.font = `600 ${11 * map.ratio}px system-ui, sans-serif`;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (const { name, corners } of mission.areas) {
      line(corners, true);
      pen.globalAlpha = 0.18;
      pen.fill();
      pen.globalAlpha = 1;
      const middle = [0, 1].map((axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length);
      pen.fillText(name, ...map.toScreen(middle));
    }
    pen.setLineDash([5 * map.ratio, 4 * map.ratio]);
    line(mission.corners, false);
    for (const corner of mission.corners) { const [x, y] = map.toScreen(corner); pen.fillRect(x - 4 * map.ratio, y - 4 * map.ratio, 8 * map.ratio, 8 * map.ratio); }
    pen.restore();
  },
  drawOthers(pen, colours) {
    const { map, world } = jauspy;
    for (const [number, name, x, y, yaw] of world.others ?? []) {
      const size = Math.max(10 * map.ratio, 0.35 * map.scale * map.ratio);
      const [right, down] = map.toScreen([x, y]);
      pen.save();
      pen.translate(right, down);
      pen.rotate(-yaw);
      pen.beginPath();
      for (const [ahead, aside] of [[1, 0], [-0.75, 0.68], [-0.4, 0], [-0.75, -0.68]]) pen.lineTo(ahead * size, -aside * size);
      pen.closePath();
      pen.fillStyle = colours.quiet;
      pen.fill();
      pen.lineWidth = 2 * map.ratio;
      pen.strokeStyle = colours.panel;
      pen.stroke();
      pen.restore();
      pen.fillStyle = colours.text;
      pen.textAlign = "left";
      pen.textBaseline = "middle";
      pen.font = `${11 * map.ratio}px system-ui, sans-serif`;
      pen.fillText(`${number} ${name}`, right + size + 4 * map.ratio, down);
    }
  },
};
