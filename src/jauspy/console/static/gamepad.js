// Gamepads: what moves while a dead-man's button is held, mapping and calibration of each pad. console.js is loaded before.
"use strict";

jauspy.gamepad = {
  DEAD_ZONE: 0.15,
  // Standard layout of the Gamepad API: axes 0 to 3 are the left and the right stick, buttons 4 and 5 the shoulders.
  usual: {
    driveHold: 4, armHold: 5, cameraHold: 6, close: 0, open: 1,
    forward: "-1", left: "-0", armX: "-1", armY: "-0", armZ: "-3", armYaw: "-2", cameraRight: "2", cameraUp: "-3",
  },
  buttons: { driveHold: jauspy._("hold to drive"), armHold: jauspy._("hold to move the arm"), cameraHold: jauspy._("hold to turn the camera"), close: jauspy._("close gripper"), open: jauspy._("open gripper") },
  axes: {
    forward: jauspy._("drive forward"), left: jauspy._("turn left"), armX: jauspy._("arm forward"), armY: jauspy._("arm left"), armZ: jauspy._("arm up"), armYaw: jauspy._("turn tool left"),
    cameraRight: jauspy._("camera right"), cameraUp: jauspy._("camera up"),
  },
  armed: new Map(), // index of a pad to the names of dead-man's buttons seen released since the page has focus and control
  pressed: new Map(), // index of a pad to the names of gripper buttons that are down
  CAMERA_PERIOD: 200, // milliseconds between two turns of the camera
  turned: 0, // when the camera was turned last, by performance.now()
  calibration: null, // while it runs: { pad, least, most }

  key: (pad) => `jauspy-gamepad:${pad.id}`,
  settings(pad) {
    const gamepad = jauspy.gamepad;
    let kept = {};
    try {
      kept = JSON.parse(localStorage.getItem(gamepad.key(pad)) ?? "{}");
    } catch { /* nothing readable was kept */ }
    const map = { ...gamepad.usual };
    for (const name of Object.keys(gamepad.buttons)) {
      if (Number.isInteger(kept.map?.[name]) && kept.map[name] >= -1 && kept.map[name] < 32) map[name] = kept.map[name];
    }
    for (const name of Object.keys(gamepad.axes)) {
      if (/^(-?\d{1,2})?$/.test(kept.map?.[name] ?? "x")) map[name] = kept.map[name];
    }
    const ranges = Array.isArray(kept.ranges) ? kept.ranges : [];
    return { map, ranges };
  },
  keep(pad, settings) {
    try {
      localStorage.setItem(jauspy.gamepad.key(pad), JSON.stringify(settings));
    } catch { /* this browser keeps nothing */ }
  },
  pads: () => [...(navigator.getGamepads?.() ?? [])].filter((pad) => pad?.connected !== false && pad),

  // -1 to 1 of an axis, calibrated and without its dead zone; `axis` as "-1": axis 1, turned round. 0 for none.
  value(pad, settings, axis) {
    if (axis === "") return 0;
    const index = Math.abs(Number(axis));
    const raw = pad.axes[index];
    if (!Number.isFinite(raw)) return 0;
    const [least, centre, most] = settings.ranges[index] ?? [-1, 0, 1];
    const reach = raw < centre ? centre - least : most - centre;
    const value = reach > 0.2 ? Math.max(-1, Math.min(1, (raw - centre) / reach)) : 0;
    const zone = jauspy.gamepad.DEAD_ZONE;
    const moved = Math.abs(value) < zone ? 0 : (Math.sign(value) * (Math.abs(value) - zone)) / (1 - zone);
    return axis.startsWith("-") ? -moved : moved;
  },
  // True while a dead-man's button is held that was seen released since this page has the focus, and since a stop and a
  // change of control.
  holds(pad, settings, name) {
    const gamepad = jauspy.gamepad;
    const down = pad.buttons[settings.map[name]]?.pressed === true;
    if (!document.hasFocus() || document.hidden) {
      gamepad.armed.clear();
      return false;
    }
    const armed = gamepad.armed.get(pad.index) ?? new Set();
    gamepad.armed.set(pad.index, armed);
    if (!down) armed.add(name);
    return down && armed.has(name) && gamepad.calibration === null;
  },
  // What drives: [forward, left]. Without control nothing is sent: what is held when control comes must move nothing.
  drive() {
    const gamepad = jauspy.gamepad;
    let [forward, left] = [0, 0];
    for (const pad of gamepad.pads()) {
      const settings = gamepad.settings(pad);
      if (!gamepad.holds(pad, settings, "driveHold")) continue;
      forward += gamepad.value(pad, settings, settings.map.forward);
      left += gamepad.value(pad, settings, settings.map.left);
    }
    if ((forward || left) && !jauspy.operates) jauspy.answerDrive(jauspy._("take control first"));
    return jauspy.operates ? [forward, left] : [0, 0];
  },
  // What moves the tool of the arm: shares of its limits along x, y, z and about x, y, z.
  arm() {
    const gamepad = jauspy.gamepad;
    const velocity = [0, 0, 0, 0, 0, 0];
    for (const pad of gamepad.pads()) {
      const settings = gamepad.settings(pad);
      if (!gamepad.holds(pad, settings, "armHold") || !jauspy.operates) continue;
      for (const [axis, name] of [[0, "armX"], [1, "armY"], [2, "armZ"], [5, "armYaw"]]) {
        velocity[axis] += gamepad.value(pad, settings, settings.map[name]);
      }
    }
    return velocity;
  },
  // Turns the camera of the large picture; each turn is small, so that it stops soon after the button is released.
  camera() {
    const gamepad = jauspy.gamepad;
    const now = performance.now();
    let [right, up] = [0, 0];
    for (const pad of gamepad.pads()) {
      const settings = gamepad.settings(pad);
      if (!gamepad.holds(pad, settings, "cameraHold") || !jauspy.operates) continue;
      right += gamepad.value(pad, settings, settings.map.cameraRight);
      up += gamepad.value(pad, settings, settings.map.cameraUp);
    }
    if (!(right || up) || now - gamepad.turned < gamepad.CAMERA_PERIOD) return;
    gamepad.turned = now;
    const share = (value) => Math.max(-1, Math.min(1, value));
    emitEvent("camera_pointed", { what: "turn", x: share(right), y: share(up), aspect: 1 });
  },
  // Gripper buttons act once a press, and while the button for the arm is held.
  grip() {
    const gamepad = jauspy.gamepad;
    for (const pad of gamepad.pads()) {
      const settings = gamepad.settings(pad);
      const before = gamepad.pressed.get(pad.index) ?? new Set();
      const now = new Set(["close", "open"].filter((name) => pad.buttons[settings.map[name]]?.pressed === true));
      gamepad.pressed.set(pad.index, now);
      if (!gamepad.holds(pad, settings, "armHold") || !jauspy.operates) continue;
      for (const name of now) if (!before.has(name)) document.querySelector(`button.grip-${name}`)?.click();
    }
  },
  forget() {
    jauspy.gamepad.armed.clear();
  },

  // --- the panel: a table for each pad -----------------------------------------------------------------------------
  element(tag, text, parent) {
    const made = document.createElement(tag);
    made.textContent = text;
    parent?.append(made);
    return made;
  },
  choice(label, options, chosen, parent, choose) {
    const gamepad = jauspy.gamepad;
    const row = gamepad.element("label", `${label} `, parent);
    const select = gamepad.element("select", "", row);
    for (const [value, text] of options) {
      const option = gamepad.element("option", text, select);
      option.value = value;
      option.selected = value === String(chosen);
    }
    select.addEventListener("change", () => choose(select.value));
  },
  card(pad) {
    const gamepad = jauspy.gamepad;
    const card = document.createElement("div");
    card.dataset.pad = pad.id;
    gamepad.element("b", pad.id.slice(0, 60), card);
    const state = gamepad.element("div", "", card);
    state.className = "hint pad-state";
    const settings = gamepad.settings(pad);
    const change = (name, value) => {
      settings.map[name] = value;
      gamepad.keep(pad, settings);
      gamepad.forget();
    };
    const buttons = [["-1", jauspy._("none")], ...pad.buttons.map((button, index) => [String(index), jauspy._("button {index}", { index })])];
    for (const [name, label] of Object.entries(gamepad.buttons)) {
      gamepad.choice(label, buttons, settings.map[name], card, (value) => change(name, Number(value)));
    }
    const axes = [["", jauspy._("none")], ...pad.axes.flatMap((axis, index) => [[`${index}`, jauspy._("axis {index}", { index })], [`-${index}`, jauspy._("axis {index}, turned round", { index })]])];
    for (const [name, label] of Object.entries(gamepad.axes)) {
      gamepad.choice(label, axes, settings.map[name], card, (value) => change(name, value));
    }
    const button = gamepad.element("button", jauspy._("calibrate"), card);
    button.className = "quiet pad-calibrate";
    button.addEventListener("click", () => gamepad.calibrate(pad.index, settings, button));
    const usual = gamepad.element("button", jauspy._("usual mapping"), card);
    usual.className = "quiet";
    usual.addEventListener("click", () => { gamepad.keep(pad, {}); gamepad.forget(); card.dataset.pad = ""; });
    return card;
  },
  // The first click takes the centres, with sticks released; then sticks are moved to their ends; the second click ends it.
  calibrate(index, settings, button) {
    const gamepad = jauspy.gamepad;
    const pad = gamepad.pads().find((other) => other.index === index);
    if (!pad) return;
    if (gamepad.calibration === null) {
      gamepad.calibration = { index, ranges: pad.axes.map((value) => [value, value, value]) };
      button.textContent = jauspy._("move all sticks to their ends, then click here");
      return;
    }
    const { ranges } = gamepad.calibration;
    gamepad.calibration = null;
    gamepad.forget();
    settings.ranges = ranges.map(([least, centre, most]) => (most - least > 0.5 ? [least, centre, most] : [-1, 0, 1]));
    gamepad.keep(pad, settings);
    button.textContent = jauspy._("calibrate");
  },
  measure() {
    const { calibration } = jauspy.gamepad;
    const pad = calibration && jauspy.gamepad.pads().find((other) => other.index === calibration.index);
    if (!pad) { jauspy.gamepad.calibration = null; return; }
    pad.axes.forEach((value, index) => {
      const range = calibration.ranges[index];
      if (range) [range[0], range[2]] = [Math.min(range[0], value), Math.max(range[2], value)];
    });
  },
  show() {
    const gamepad = jauspy.gamepad;
    const panel = document.getElementById("gamepads");
    if (!panel) return;
    const pads = gamepad.pads();
    panel.closest("details").hidden = pads.length === 0;
    if ([...panel.children].map((card) => card.dataset.pad).join("\n") !== pads.map((pad) => pad.id).join("\n")) {
      panel.replaceChildren(...pads.map(gamepad.card));
    }
    pads.forEach((pad, place) => {
      const settings = gamepad.settings(pad);
      const holds = ["driveHold", "armHold", "cameraHold"].filter((name) => gamepad.holds(pad, settings, name));
      const text = holds.length ? jauspy._("held: {buttons}", { buttons: holds.map((name) => gamepad.buttons[name]).join(", ") })
        : document.hasFocus() ? jauspy._("nothing moves without a held button") : jauspy._("this page has not the focus: nothing moves");
      const state = panel.children[place].querySelector(".pad-state");
      if (state.textContent !== text) state.textContent = text;
    });
  },
  tick() {
    jauspy.gamepad.measure();
    jauspy.gamepad.grip();
    jauspy.gamepad.camera();
  },
  start() {
    for (const name of ["blur", "pagehide", "gamepaddisconnected"]) addEventListener(name, jauspy.gamepad.forget);
    setInterval(jauspy.gamepad.tick, 50);
    setInterval(jauspy.gamepad.show, 250);
  },
};
jauspy.gamepad.start();
