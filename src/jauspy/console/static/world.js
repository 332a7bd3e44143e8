// The tab World: one connection that is open while the tab is visible, and the 3-D view (three.js of NiceGUI's wheel).
"use strict";

jauspy.world = {
  MAX_TRACK: 5000,
  SLOW_PICTURE: 50,  // ms
  MAX_PAUSE: 500,  // ms
  robot: 0,
  socket: null,
  model: null,
  pose: null,
  joints: [],
  track: [],
  drift: [0, 0, 0],
  map: null,
  scan: null,
  clouds: new Map(),
  waypoints: [],
  ghost: null,
  wanted: null, // positions by joint that sliders ask for, and whether the robot would touch itself
  geo: null, // latitude and longitude of the origin, direction of x clockwise from north, radians
  others: [], // robots: number, name, x, y, yaw
  show: { frames: false, scan: true, follow: true, play: true, costs: false },

  // --- the connection -------------------------------------------------------------------------------------------
  connect() {
    jauspy.world.tellWaiting();
    const panel = document.getElementById("world");
    const visible = panel && panel.offsetParent !== null && !document.hidden && jauspy.robot;
    const world = jauspy.world;
    if (world.socket && (!visible || world.robot !== jauspy.robot)) { world.socket.close(); world.socket = null; }
    if (!visible) return;
    jauspy.view.watchSize();
    jauspy.map.watchSize();
    if (world.socket) return;
    if (world.robot !== jauspy.robot) world.forget();
    world.robot = jauspy.robot;
    world.track = [];
    const socket = new WebSocket(jauspy.url(`world/${world.robot}`));
    socket.binaryType = "arraybuffer";
    socket.onmessage = (event) => {
      if (world.socket !== socket) return;
      if (typeof event.data === "string") world.takeState(JSON.parse(event.data));
      else world.takeBytes(event.data);
    };
    socket.onclose = () => { if (world.socket === socket) setTimeout(() => { if (world.socket === socket) world.socket = null; }, 1000); };
    world.socket = socket;
  },
  forget() {
    Object.assign(jauspy.world, { model: null, pose: null, joints: [], track: [], drift: [0, 0, 0], map: null, scan: null, ghost: null, wanted: null, waypoints: [], geo: null, others: [] });
    jauspy.world.clouds.clear();
    jauspy.view.forget();
    jauspy.map.forget();
    jauspy.way.take({ path: [], costs: null });
  },
  takeState(state) {
    const world = jauspy.world;
    if (state.model) {
      world.model = state.model;
      const left = state.left_out.length;
      world.tell("source", state.model.source + (left ? `; ${jauspy._("{count} meshes of other formats are not shown", { count: left })}` : ""));
      jauspy.view.build();
      return;
    }
    if ("way" in state) {
      jauspy.way.take(state.way);
      return;
    }
    if ("ghost" in state) {
      world.ghost = state.ghost;
      jauspy.view.ghostChanged = true;
      world.changed();
      return;
    }
    if (state.joints) world.joints = state.joints;
    if (state.pose) world.pose = state.pose;
    if (state.map) world.drift = state.map;
    if (state.geo) world.geo = state.geo;
    if (state.others) world.others = state.others;
    if (state.notes) world.tell("notes", state.notes.join("; "));
    world.tell("age", state.age ? jauspy._("the pose is {age} s old", { age: state.age }) : "");
    if (state.track) {
      world.track.push(...state.track);
      if (world.track.length > world.MAX_TRACK) world.track.splice(0, world.track.length - world.MAX_TRACK);
    }
    world.changed();
  },
  // What the 3-D view waits for; nothing when the robot is drawn.
  tellWaiting() {
    const { renderer, starting, missing } = jauspy.view;
    const { model, socket } = jauspy.world;
    let text = "";
    if (starting && !renderer) text = jauspy._("starting the 3-D view \u2026");
    else if (!model && socket?.readyState !== WebSocket.OPEN) text = jauspy._("connecting to the console \u2026");
    else if (!model) text = jauspy._("asking the robot what it looks like \u2026");
    else if (missing) text = jauspy._("loading shapes: {count} left", { count: missing });
    jauspy.world.tell("waiting", jauspy.view.failed ? "" : text);
  },
  tell(what, text) {
    const line = document.querySelector(`#world [data-line="${what}"]`);
    if (line && line.textContent !== text) line.textContent = line.title = text;
  },
  async takeBytes(buffer) {
    const world = jauspy.world;
    const data = new DataView(buffer);
    const kind = data.getUint8(0);
    if (kind === 1) {
      const map = { columns: data.getUint16(2, true), rows: data.getUint16(4, true), x: data.getFloat32(8, true), y: data.getFloat32(12, true), side: data.getFloat32(16, true) };
      const inflated = new Blob([buffer.slice(20)]).stream().pipeThrough(new DecompressionStream("deflate"));
      map.cells = new Uint8Array(await new Response(inflated).arrayBuffer());
      world.map = map;
      jauspy.view.mapChanged = true;
    } else if (kind === 2) {
      world.scan = { height: data.getFloat32(4, true), points: new Int16Array(buffer.slice(8)) };
    } else if (kind === 3) {
      const [values, length, count] = [data.getUint8(1), data.getUint16(2, true), data.getUint32(4, true)];
      const link = new TextDecoder().decode(new Uint8Array(buffer, 8, length)).trim();
      world.clouds.set(link, { values, count, points: new Float32Array(buffer.slice(8 + length)) });
      jauspy.view.cloudsChanged = true;
    }
    world.changed();
  },
  // Draw soon. Without a GPU a picture takes a tenth of a second, and the page answers to nothing meanwhile: so the next
  // one waits twice as long as the last one took.
  changed() {
    const world = jauspy.world;
    world.stale = true;
    if (world.drawing) return;
    world.drawing = true;
    requestAnimationFrame((begun) => {
      world.stale = false;
      jauspy.view.update();
      jauspy.map.draw();
      requestAnimationFrame((shown) => {
        const pause = shown - begun > world.SLOW_PICTURE ? Math.min(2 * (shown - begun), world.MAX_PAUSE) : 0;
        setTimeout(() => { world.drawing = false; if (world.stale) world.changed(); }, pause);
      });
    });
  },
  colours() {
    const dark = document.body.classList.contains("body--dark");
    const style = getComputedStyle(document.body);
    const of = (name) => style.getPropertyValue(`--${name}`).trim();
    return {
      dark, ground: dark ? "#171b20" : "#e9ebee", line: dark ? "#39424d" : "#d0d4da", free: dark ? "#262c34" : "#ffffff", wall: dark ? "#9aa7b5" : "#4a5561",
      text: of("text"), quiet: of("quiet"), accent: of("accent"), track: dark ? "#e6b93c" : "#b07a00", scan: dark ? "#ff8a3d" : "#d55e00", route: of("accent"), done: of("quiet"), sent: of("ready"), panel: of("panel"),
    };
  },
  // The cells as a picture, for both views: transparent where nothing is known.
  picture(map) {
    const colours = jauspy.world.colours();
    const key = `${colours.free}${colours.wall}`;
    if (map.key === key) return map.canvas;
    const rgb = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
    const [free, wall] = [rgb(colours.free), rgb(colours.wall)];
    const canvas = map.canvas ?? document.createElement("canvas");
    [canvas.width, canvas.height] = [map.columns, map.rows];
    const image = new ImageData(map.columns, map.rows);
    for (let row = 0; row < map.rows; row += 1) {
      for (let column = 0; column < map.columns; column += 1) {
        const value = map.cells[row * map.columns + column];
        if (value === 255) continue;
        const at = 4 * ((map.rows - 1 - row) * map.columns + column);
        const part = Math.max(0, Math.min(1, (value - 40) / 30));  // one ray makes a cell free, two echoes occupied
        for (let each = 0; each < 3; each += 1) image.data[at + each] = free[each] + (wall[each] - free[each]) * part;
        image.data[at + 3] = 255;
      }
    }
    canvas.getContext("2d").putImageData(image, 0, 0);
    Object.assign(map, { canvas, key });
    return canvas;
  },
  set(name, value) {
    jauspy.world.show[name] = value;
    jauspy.world.changed();
  },
  setWanted(wanted) {
    jauspy.world.wanted = wanted;
    jauspy.view.wantedChanged = true;
    jauspy.world.changed();
  },
  // The robot's waypoints and those that were not sent yet, from the server.
  setRoute(route) {
    jauspy.world.waypoints = route;
    jauspy.world.changed();
  },
};

jauspy.view = {
  mapChanged: false,
  cloudsChanged: false,
  links: new Map(),
  moving: [],
  missing: 0,  // meshes that are being loaded

  async start() {
    const view = jauspy.view;
    const place = document.getElementById("world-3d");
    if (view.starting || !place) return;
    view.starting = true;
    const library = await import("nicegui-scene");
    const { THREE, OrbitControls, CSS2DRenderer } = library;
    try {
      view.renderer = new THREE.WebGLRenderer({ antialias: true });
    } catch {
      view.failed = true;
      place.replaceChildren(Object.assign(document.createElement("p"), { className: "hint", textContent: jauspy._("This browser has no WebGL, so there is no 3-D view; the map works.") }));
      return;
    }
    view.library = library;
    view.scene = new THREE.Scene();
    view.camera = new THREE.PerspectiveCamera(42, 1, 0.05, 500);
    view.camera.up.set(0, 0, 1);
    view.camera.position.set(-1.45, 1.3, 1.0);
    view.labels = new CSS2DRenderer();
    view.labels.domElement.className = "labels";
    view.renderer.domElement.setAttribute("role", "img");
    view.renderer.domElement.setAttribute("aria-label", jauspy._("the robot in three dimensions: a drag turns the view, the wheel zooms"));
    place.replaceChildren(view.renderer.domElement, view.labels.domElement);
    view.controls = new OrbitControls(view.camera, view.renderer.domElement);
    view.controls.target.set(0, 0, 0.25);
    view.controls.maxPolarAngle = 0.495 * Math.PI;
    view.controls.maxDistance = 60;
    view.controls.addEventListener("change", jauspy.world.changed);
    view.sky = new THREE.HemisphereLight(0xffffff, 0x8d8678, 2.2);
    const sun = new THREE.DirectionalLight(0xffffff, 2.0);
    sun.position.set(-4, 6, 9);
    view.scene.add(view.sky, sun);
    view.robot = new THREE.Group();
    view.local = new THREE.Group();
    view.mapped = new THREE.Group();
    view.scene.add(view.local, view.mapped);
    view.local.add(view.robot);
    const points = (size) => new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ size, sizeAttenuation: false }));
    view.scan = points(3);
    view.robot.add(view.scan);
    view.track = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial());
    view.route = new THREE.Group();
    view.origin = new THREE.AxesHelper(0.5);
    view.local.add(view.track, view.route, view.origin);
    view.watchSize();
    view.controls.addEventListener("start", () => { view.turned = true; });
    view.listenToClicks(view.renderer.domElement);
    if (jauspy.world.model) view.build();
  },
  watchSize() {
    const place = document.getElementById("world-3d");
    const view = jauspy.view;
    if (!place) return;
    if (place.offsetParent !== null) view.start();
    if (!view.renderer) return;
    const [width, height] = [place.clientWidth, place.clientHeight];
    const dark = document.body.classList.contains("body--dark");
    if (!width || !height || (view.width === width && view.height === height && view.dark === dark)) return;
    Object.assign(view, { width, height, dark });
    view.renderer.setPixelRatio(Math.min(2, devicePixelRatio));
    view.renderer.setSize(width, height);
    view.labels.setSize(width, height);
    view.camera.aspect = width / height;
    view.camera.updateProjectionMatrix();
    view.paint();
    view.fit();
    jauspy.world.changed();
  },
  paint() {
    const { THREE } = jauspy.view.library;
    const view = jauspy.view;
    const colours = jauspy.world.colours();
    view.renderer.setClearColor(colours.ground);
    view.scene.fog = new THREE.Fog(colours.ground, 14, 34);
    view.local.remove(view.grid);
    view.grid = new THREE.LineSegments(view.gridOfMetres(20), new THREE.LineBasicMaterial({ color: colours.line }));
    // The floor, then the grid, then everything else: what lies on the floor needs no depth.
    Object.assign(view.grid.material, { depthTest: false, depthWrite: false });
    view.grid.renderOrder = -1;
    view.local.add(view.grid);
    view.scan.material.color.set(colours.scan);
    view.track.material.color.set(colours.track);
    view.mapChanged = true;
  },

  // --- the robot ------------------------------------------------------------------------------------------------
  forget() {
    const view = jauspy.view;
    if (!view.robot) return;
    for (const child of [...view.robot.children]) if (child !== view.scan) view.robot.remove(child);
    for (const group of [view.mapped, view.route]) group.clear();
    for (const copy of [view.ghost, view.wanted]) if (copy) view.local.remove(copy.robot);
    view.ghost = view.wanted = null;
    view.links.clear();
    view.moving = [];
    view.wasAt = null;
    view.turned = false;
  },
  pose(object, [x, y, z, a, b, c, d]) {
    object.position.set(x, y, z);
    object.quaternion.set(a, b, c, d);
  },
  build() {
    const view = jauspy.view;
    const model = jauspy.world.model;
    if (!view.renderer || view.built === model) return;
    view.forget();
    view.built = model;
    const { THREE, CSS2DObject } = view.library;
    const link = (name) => {
      if (!view.links.has(name)) {
        const group = new THREE.Group();
        const axes = new THREE.AxesHelper(0.12);
        const text = Object.assign(document.createElement("span"), { textContent: name, className: "frame" });
        axes.add(new CSS2DObject(text));
        axes.material.depthTest = false;
        axes.renderOrder = 2;
        axes.visible = false;
        group.add(axes);
        view.links.set(name, { group, axes });
      }
      return view.links.get(name).group;
    };
    view.robot.add(link(model.root));
    for (const joint of model.joints) {
      const origin = new THREE.Group();
      view.pose(origin, joint.origin);
      origin.add(link(joint.child));
      link(joint.parent).add(origin);
      if (joint.kind !== "fixed") view.moving.push({ name: joint.name, kind: joint.kind, group: link(joint.child), axis: new THREE.Vector3(...joint.axis) });
    }
    const meshes = new Map();
    view.missing = 0;
    for (const shape of model.shapes) view.addShape(shape, link, meshes);
    if (!model.shapes.some((shape) => shape.kind !== "line")) view.robot.add(view.arrow());
    view.update();
    view.fit();
    jauspy.world.changed();
  },
  // Step back until all of the robot is in the view, once all of it is there, unless somebody has turned the view.
  // What stands in a cell is seen from ahead, where its work is; a vehicle from behind.
  fit() {
    const view = jauspy.view;
    if (view.missing || view.turned) return;
    const { THREE } = view.library;
    const box = new THREE.Box3();
    view.robot.updateWorldMatrix(true, true);
    const { camera, controls } = view;
    const stands = view.moving.some(({ kind }) => kind === "free");
    for (const { group } of stands ? view.moving : []) box.expandByObject(group);
    if (!stands) view.robot.traverse((each) => { if (each.isMesh) box.expandByObject(each); });
    if (box.isEmpty()) return;
    const away = stands ? new THREE.Vector3(1.5, -1.5, 1.2) : camera.position.clone().sub(controls.target);
    const nearest = stands ? 0 : away.length();
    const middle = box.getCenter(new THREE.Vector3());
    const [ahead, right] = [away.clone().normalize().negate(), new THREE.Vector3(-away.y, away.x, 0).normalize()];
    const up = right.clone().cross(ahead);
    const high = Math.tan((camera.fov * Math.PI) / 360) * 0.92;
    let far = 0;
    for (let corner = 0; corner < 8; corner += 1) {
      const at = new THREE.Vector3(...["x", "y", "z"].map((axis, bit) => box[corner & (1 << bit) ? "max" : "min"][axis])).sub(middle);
      far = Math.max(far, Math.max(Math.abs(at.dot(up)) / high, Math.abs(at.dot(right)) / (high * camera.aspect)) - at.dot(ahead));
    }
    if (far <= nearest) return;
    controls.target.copy(middle);
    camera.position.copy(middle).add(away.setLength(far));
    jauspy.world.changed();
  },
  // In place of a body that nobody has described: where the pose is, and where ahead is.
  arrow() {
    const { THREE } = jauspy.view.library;
    const outline = new THREE.Shape([[0.35, 0], [-0.2, 0.18], [-0.1, 0], [-0.2, -0.18]].map(([x, y]) => new THREE.Vector2(x, y)));
    const arrow = new THREE.Mesh(new THREE.ExtrudeGeometry(outline, { depth: 0.04, bevelEnabled: false }), new THREE.MeshLambertMaterial());
    arrow.material.color.set(jauspy.world.colours().accent);
    return arrow;
  },
  addShape(shape, link, meshes) {
    const { THREE, CSS2DObject } = jauspy.view.library;
    const [r, g, b, a] = shape.colour;
    const material = new THREE.MeshLambertMaterial({ opacity: a, transparent: a < 1 });
    material.color.setRGB(r, g, b, THREE.SRGBColorSpace);
    const place = new THREE.Group();
    jauspy.view.pose(place, shape.origin);
    link(shape.link).add(place);
    const add = (geometry) => { const mesh = new THREE.Mesh(geometry, material); place.add(mesh); return mesh; };
    if (shape.label) place.add(new CSS2DObject(Object.assign(document.createElement("span"), { textContent: shape.label, className: "frame" })));
    if (shape.kind === "box") add(new THREE.BoxGeometry(...shape.size));
    else if (shape.kind === "sphere") add(new THREE.SphereGeometry(shape.radius, 20, 14));
    else if (shape.kind === "cylinder") add(new THREE.CylinderGeometry(shape.radius, shape.radius, shape.length, 24).rotateX(Math.PI / 2));
    else if (shape.kind === "line") {
      const end = link(shape.to).parent.position;
      const length = Math.max(0.001, end.length());
      add(new THREE.SphereGeometry(0.035, 16, 12));
      const bone = add(new THREE.CylinderGeometry(0.022, 0.022, length, 12).translate(0, length / 2, 0));
      bone.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), end.clone().divideScalar(length));
    } else if (shape.kind === "mesh") {
      const { view } = jauspy;
      const model = view.built;
      const ended = () => { if (view.built === model) { view.missing -= 1; view.fit(); jauspy.world.tellWaiting(); } };
      if (!meshes.has(shape.url)) meshes.set(shape.url, view.load(shape.url, shape.format));
      view.missing += 1;
      meshes.get(shape.url).then((loaded) => {
        const mesh = loaded.isBufferGeometry ? add(loaded) : place.add(loaded.clone());
        mesh.scale.set(...shape.scale);
        jauspy.world.changed();
      }, () => jauspy.world.tell("notes", jauspy._("a mesh of the robot cannot be loaded"))).finally(ended);
    }
  },
  async load(url, format) {
    const { GLTFLoader, STLLoader } = jauspy.view.library;
    if (format === "stl") return new STLLoader().loadAsync(url);
    if (format === "glb" || format === "gltf") return (await new GLTFLoader().loadAsync(url)).scene;
    const answer = await fetch(url);
    if (!answer.ok) throw new Error(answer.statusText);
    return jauspy.view.parseObj(await answer.text());
  },
  parseObj(text) {
    const { THREE } = jauspy.view.library;
    const [points, normals, position, normal] = [[], [], [], []];
    for (const line of text.split("\n")) {
      const words = line.trim().split(/\s+/);
      if (words[0] === "v") points.push(words.slice(1, 4).map(Number));
      else if (words[0] === "vn") normals.push(words.slice(1, 4).map(Number));
      else if (words[0] === "f") {
        const corners = words.slice(1).map((word) => word.split("/").map(Number));
        for (let at = 2; at < corners.length; at += 1) {
          for (const [point, , direction] of [corners[0], corners[at - 1], corners[at]]) {
            position.push(...points.at(point > 0 ? point - 1 : point));
            if (direction) normal.push(...normals.at(direction > 0 ? direction - 1 : direction));
          }
        }
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
    if (normal.length === position.length) geometry.setAttribute("normal", new THREE.Float32BufferAttribute(normal, 3));
    else geometry.computeVertexNormals();
    return geometry;
  },

  // --- drawing --------------------------------------------------------------------------------------------------
  update() {
    const view = jauspy.view;
    const world = jauspy.world;
    const place = document.getElementById("world-3d");
    if (!view.renderer || !place || place.offsetParent === null) return;
    const { THREE } = view.library;
    view.place(view.moving, world.joints);
    for (const { axes } of view.links.values()) axes.visible = world.show.frames;
    if (world.show.frames) view.spreadLabels();
    if (world.pose) {
      const [x, y, z, roll, pitch, yaw] = world.pose;
      view.robot.position.set(x, y, z);
      view.robot.rotation.set(roll, pitch, yaw, "ZYX");
      view.grid.position.set(Math.round(x), Math.round(y), 0);
      const at = new THREE.Vector3(x, y, z);
      if (world.show.follow || !view.wasAt) {
        const step = at.clone().sub(view.wasAt ?? new THREE.Vector3());
        view.camera.position.add(step);
        view.controls.target.add(step);
      }
      view.wasAt = at;
    }
    view.updateGhost();
    view.updateWanted();
    view.updateLines();
    if (world.scan && world.scan !== view.shownScan) {
      view.shownScan = world.scan;
      const { points, height } = world.scan;
      const position = new Float32Array((3 * points.length) / 2);
      for (let at = 0; at < points.length / 2; at += 1) position.set([points[2 * at] / 100, points[2 * at + 1] / 100, height], 3 * at);
      view.replace(view.scan, position);
    }
    view.scan.visible = world.show.scan && !!world.scan;
    if (view.cloudsChanged) view.updateClouds();
    for (const { cloud } of view.links.values()) if (cloud) cloud.visible = world.show.scan;
    if (view.mapChanged) view.updateMap();
    const [x, y, yaw] = world.drift;
    view.mapped.position.set(x, y, 0);
    view.mapped.rotation.z = yaw;
    view.controls.update();
    view.renderer.render(view.scene, view.camera);
    view.labels.render(view.scene, view.camera);
    place.dataset.pictures = 1 + Number(place.dataset.pictures ?? 0);
  },
  place(moving, joints) {
    moving.forEach(({ kind, group, axis }, at) => {
      const value = joints[at] ?? 0;
      if (kind === "free") {  // a part that a sensor sees
        group.visible = Array.isArray(value);
        if (group.visible) jauspy.view.pose(group, value);
      } else if (kind === "prismatic") group.position.copy(axis).multiplyScalar(value);
      else group.quaternion.setFromAxisAngle(axis, value);
    });
  },
  // A click on a thing, while the operator has asked for that: its place in the robot's frame goes to the console.
  pick(on) {
    jauspy.view.picking = on;
    document.getElementById("world-3d")?.classList.toggle("picking", on);
  },
  listenToClicks(canvas) {
    let pressed = null;
    canvas.addEventListener("pointerdown", (event) => { pressed = event.button === 0 ? [event.clientX, event.clientY] : null; });
    canvas.addEventListener("pointerup", (event) => {
      if (!jauspy.view.picking || !pressed || Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) > 6) return;
      const thing = jauspy.view.thingAt(canvas, event);
      if (thing) emitEvent("reach_pointed", { x: thing.x, y: thing.y, z: thing.z });
    });
  },
  // What the ray through the pointer meets first: a point of a cloud or scan, a wall of the map, or the ground.
  thingAt(canvas, event) {
    const view = jauspy.view;
    const { THREE } = view.library;
    const box = canvas.getBoundingClientRect();
    const caster = new THREE.Raycaster();
    caster.params.Points.threshold = 0.02; // metres
    caster.setFromCamera(new THREE.Vector2((2 * (event.clientX - box.left)) / box.width - 1, 1 - (2 * (event.clientY - box.top)) / box.height), view.camera);
    const clouds = [...view.links.values()].map(({ cloud }) => cloud).filter((cloud) => cloud?.visible);
    const [met] = caster.intersectObjects([...clouds, ...(view.scan.visible ? [view.scan] : []), ...view.mapped.children], false);
    const ground = caster.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), 0), new THREE.Vector3());
    const place = met?.point ?? ground;
    return place && view.robot.worldToLocal(place.clone());
  },
  // The planned motion: a transparent copy of the robot that moves along it again and again.
  updateGhost() {
    const view = jauspy.view;
    const { ghost, show } = jauspy.world;
    if (view.ghostChanged) {
      view.ghostChanged = false;
      if (view.ghost) view.local.remove(view.ghost.robot);
      view.ghost = ghost && view.built ? view.copyRobot() : null;
      document.getElementById("world-3d").dataset.ghost = view.ghost ? ghost.frames.length : 0;
    }
    if (!view.ghost || !ghost) return;
    const { robot, moving } = view.ghost;
    robot.position.copy(view.robot.position);
    robot.quaternion.copy(view.robot.quaternion);
    const now = performance.now() / 1000;
    if (show.play) view.ghost.time += now - view.ghost.before;
    view.ghost.before = now;
    const rest = 0.8;  // seconds at the end
    const part = Math.min(1, (view.ghost.time % (ghost.duration + rest)) / Math.max(0.001, ghost.duration));
    view.place(moving, ghost.frames[Math.round(part * (ghost.frames.length - 1))]);
    if (show.play) setTimeout(jauspy.world.changed, 40);
  },
  // What the sliders of the arm ask for: a transparent copy, red if it would touch itself or the ground.
  updateWanted() {
    const view = jauspy.view;
    const { wanted, joints } = jauspy.world;
    if (view.wantedChanged) {
      view.wantedChanged = false;
      if (view.wanted) view.local.remove(view.wanted.robot);
      view.wanted = wanted && view.built ? view.copyRobot(wanted.touches ? "#e02424" : "#2fa66a") : null;
      document.getElementById("world-3d").dataset.wanted = view.wanted ? (wanted.touches ? "touches" : "free") : "none";
    }
    if (!view.wanted || !wanted) return;
    view.wanted.robot.position.copy(view.robot.position);
    view.wanted.robot.quaternion.copy(view.robot.quaternion);
    view.place(view.wanted.moving, view.moving.map(({ name }, at) => wanted.positions[name] ?? joints[at]));
  },
  copyRobot(colour = jauspy.world.colours().accent) {
    const view = jauspy.view;
    const { THREE } = view.library;
    const material = new THREE.MeshLambertMaterial({ color: colour, transparent: true, opacity: 0.28, depthWrite: false });
    const copies = new Map();
    const copy = (object) => {
      const made = object.isMesh ? new THREE.Mesh(object.geometry, material) : new THREE.Group();
      made.position.copy(object.position);
      made.quaternion.copy(object.quaternion);
      made.scale.copy(object.scale);
      copies.set(object, made);
      for (const child of object.children) if (!child.isLine && !child.isPoints && !child.isCSS2DObject) made.add(copy(child));
      return made;
    };
    const robot = copy(view.robot);
    view.local.add(robot);
    return { robot, moving: view.moving.map((joint) => ({ ...joint, group: copies.get(joint.group) })), time: 0, before: performance.now() / 1000 };
  },
  // Names that would cover each other are left out, those of the tips of the tree last.
  spreadLabels() {
    const view = jauspy.view;
    const { THREE } = view.library;
    const taken = [];
    for (const { axes } of [...view.links.values()].reverse()) {
      const [label] = axes.children;
      const at = axes.getWorldPosition(new THREE.Vector3()).project(view.camera);
      const [x, y] = [(at.x * view.width) / 2, (at.y * view.height) / 2];
      const width = 6.2 * label.element.textContent.length;
      label.visible = !taken.some((other) => Math.abs(other.y - y) < 15 && Math.abs(other.x - x) < (other.width + width) / 2);
      if (label.visible) taken.push({ x, y, width });
    }
  },
  replace(object, position, colour) {
    const { THREE } = jauspy.view.library;
    object.geometry.dispose();
    object.geometry = new THREE.BufferGeometry();
    object.geometry.setAttribute("position", new THREE.Float32BufferAttribute(position, 3));
    if (colour) object.geometry.setAttribute("color", new THREE.Float32BufferAttribute(colour, 3));
    object.frustumCulled = false;
  },
  updateLines() {
    const view = jauspy.view;
    const world = jauspy.world;
    const { THREE } = view.library;
    const end = world.track.at(-1);
    if (view.shownTrack !== end) {
      view.shownTrack = end;
      view.replace(view.track, world.track.flatMap(([x, y]) => [x, y, 0.01]));
    }
    if (view.shownRoute === world.waypoints && view.routeDark === view.dark) return;
    [view.shownRoute, view.routeDark] = [world.waypoints, view.dark];
    view.route.clear();
    const colours = world.colours();
    const material = new THREE.MeshBasicMaterial({ color: colours.route, transparent: true, opacity: 0.9 });
    const line = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: colours.route }));
    view.replace(line, world.waypoints.flatMap(({ x, y }) => [x, y, 0.012]));
    view.route.add(line);
    for (const { x, y, state } of world.waypoints) {
      const ring = new THREE.Mesh(new THREE.RingGeometry(state === "active" ? 0.05 : 0.09, 0.13, 32), material);
      ring.position.set(x, y, 0.014);
      view.route.add(ring);
    }
  },
  updateClouds() {
    const view = jauspy.view;
    const { THREE } = view.library;
    view.cloudsChanged = false;
    for (const [name, { values, count, points }] of jauspy.world.clouds) {
      const link = view.links.get(name);
      if (!link) continue;
      if (!link.cloud) {
        link.cloud = new THREE.Points(new THREE.BufferGeometry(), new THREE.PointsMaterial({ size: 2, sizeAttenuation: false, vertexColors: values === 6 }));
        link.group.add(link.cloud);
      }
      const [position, colour] = [new Float32Array(3 * count), values === 6 ? new Float32Array(3 * count) : null];
      for (let at = 0; at < count; at += 1) {
        for (let axis = 0; axis < 3; axis += 1) {
          position[3 * at + axis] = points[values * at + axis];
          if (colour) colour[3 * at + axis] = points[values * at + 3 + axis];
        }
      }
      view.replace(link.cloud, position, colour);
    }
  },
  // Lines of 1 m each: GL in software leaves out whole lines that pass behind the camera.
  gridOfMetres(half) {
    const { THREE } = jauspy.view.library;
    const ends = [];
    for (let across = -half; across <= half; across += 1) {
      for (let along = -half; along < half; along += 1) {
        ends.push(across, along, 0, across, along + 1, 0, along, across, 0, along + 1, across, 0);
      }
    }
    return new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
  },
  // The map lies on the ground; what is occupied stands on it as a low wall.
  updateMap() {
    const view = jauspy.view;
    const map = jauspy.world.map;
    const { THREE } = view.library;
    view.mapChanged = false;
    for (const child of [...view.mapped.children]) { child.geometry.dispose(); child.material.map?.dispose(); view.mapped.remove(child); }
    if (!map) return;
    const [width, height] = [map.columns * map.side, map.rows * map.side];
    const texture = new THREE.CanvasTexture(jauspy.world.picture(map));
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.magFilter = THREE.NearestFilter;
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(width, height), new THREE.MeshBasicMaterial({ map: texture, alphaTest: 0.5, depthTest: false, depthWrite: false }));
    floor.renderOrder = -2;
    floor.position.set(map.x + width / 2, map.y + height / 2, -0.002);
    const occupied = [];
    map.cells.forEach((value, at) => { if (value > 65 && value !== 255 && occupied.length < 20000) occupied.push(at); });
    const wall = 0.2;
    const walls = new THREE.InstancedMesh(new THREE.BoxGeometry(map.side, map.side, wall), new THREE.MeshLambertMaterial({ color: jauspy.world.colours().wall }), occupied.length);
    const matrix = new THREE.Matrix4();
    occupied.forEach((at, number) => {
      matrix.setPosition(map.x + ((at % map.columns) + 0.5) * map.side, map.y + (Math.floor(at / map.columns) + 0.5) * map.side, wall / 2);
      walls.setMatrixAt(number, matrix);
    });
    walls.frustumCulled = false;
    view.mapped.add(floor, walls);
  },
};
setInterval(() => jauspy.world.connect(), 250);
