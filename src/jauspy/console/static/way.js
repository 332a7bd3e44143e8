// The way that a navigator drives and the costs that it sees, as layers of the map of the tab World.
"use strict";

jauspy.way = {
  IMPASSABLE: 254,
  UNKNOWN: 255,
  path: [],
  costs: null,

  take({ path, costs }) {
    const way = jauspy.way;
    way.path = path;
    way.costs = costs ? { ...costs, canvas: way.picture(costs) } : null;
    document.getElementById("world-map")?.setAttribute("data-way", `${path.length} ${costs ? costs.rows * costs.columns : 0}`);
    jauspy.world.changed();
  },
  // From green over yellow to red; cells that are unknown are transparent.
  picture({ rows, columns, cells }) {
    const costs = Uint8Array.from(atob(cells), (each) => each.charCodeAt(0));
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [columns, rows];
    const image = new ImageData(columns, rows);
    costs.forEach((cost, at) => {
      if (cost === jauspy.way.UNKNOWN) return;
      const part = Math.min(1, cost / 160);
      const colour = cost >= jauspy.way.IMPASSABLE ? [150, 30, 60] : [Math.round(255 * Math.min(1, 2 * part)), Math.round(190 * Math.min(1, 2 - 2 * part)), 40];
      image.data.set([...colour, 255], 4 * at);
    });
    canvas.getContext("2d").putImageData(image, 0, 0);
    return canvas;
  },
  drawCosts(pen, unit) {
    const { costs } = jauspy.way;
    if (!costs || !jauspy.world.show.costs) return;
    const [width, height] = [costs.width * unit, costs.height * unit];
    pen.save();
    pen.translate(...jauspy.map.toScreen([costs.x, costs.y]));
    pen.rotate(-costs.yaw);
    pen.globalAlpha = 0.5;
    pen.imageSmoothingEnabled = false;
    pen.drawImage(costs.canvas, -width / 2, -height / 2, width, height);
    pen.restore();
  },
  drawPath(pen, colours) {
    if (jauspy.world.show.costs) jauspy.map.drawLine(pen, jauspy.way.path, colours.route, 2.5, [2, 4]);
  },
};
