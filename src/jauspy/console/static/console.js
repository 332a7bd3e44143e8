// Driving and the emergency stop, each on a connection of its own. Nothing here waits for the rest of the page.
"use strict";

const jauspy = {
  token: "",
  robot: 0,
  chosenBefore: null, // by the operator, before this page was loaded again
  sockets: new Map(),
  texts: JSON.parse(document.getElementById("texts")?.dataset.texts || "{}"), // by the English ones

  // A text in the language of the page; `{name}` in it stands for a value.
  _(text, values = {}) {
    const own = Object.hasOwn(jauspy.texts, text) ? jauspy.texts[text] : text;
    return own.replace(/\{(\w+)\}/g, (all, name) => (Object.hasOwn(values, name) ? values[name] : all));
  },
  url(path) {
    return `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws/${path}/${jauspy.token}`;
  },

  // --- emergency stop: F8, Escape while nothing is open, or the button --------------------------------------------------------------------
  connectStop() {
    const socket = new WebSocket(jauspy.url("stop"));
    socket.onmessage = (event) => { clearTimeout(jauspy.unconfirmed); jauspy.say(event.data); };
    socket.onclose = () => setTimeout(jauspy.connectStop, 500);
    jauspy.stopSocket = socket;
  },
  // Buttons have no handlers of their own, which the Content-Security-Policy forbids: `data-do` names what they do.
  actions: {
    stop: (target) => jauspy.stop(target),
    clear: (target) => jauspy.clear(target),
    scheme: () => jauspy.nextScheme(),
    sound: () => jauspy.alarm.toggleSound(),
    zoom: (factor) => jauspy.map.zoom(Number(factor)),
  },
  listenToButtons() {
    document.addEventListener("click", (event) => {
      const button = event.target.closest?.("button[data-do]");
      if (button && Object.hasOwn(jauspy.actions, button.dataset.do)) jauspy.actions[button.dataset.do](button.dataset.to);
    }, true);
  },
  // A click is for what was pressed, also when new content has moved it before the button is released: browsers then send
  // the click to what lies there now, or to what contains both. Whoever moves the pointer away presses nothing.
  keepClicks() {
    const reach = 8; // pixels, within which a hand holds still
    let pressed = null;
    addEventListener("pointerdown", (event) => {
      const target = event.target.closest?.("button, .traffic tbody tr");
      pressed = target && event.button === 0 ? { target, x: event.clientX, y: event.clientY } : null;
    }, true);
    addEventListener("click", (event) => {
      const { target, x, y } = pressed ?? {};
      pressed = null;
      if (!target || !event.isTrusted || event.detail === 0 || target.contains(event.target)) return; // 0: by a key
      if (Math.hypot(event.clientX - x, event.clientY - y) > reach) return;
      event.stopImmediatePropagation();
      event.preventDefault();
      target.click();
    }, true);
  },
  pickFile(panel) {
    getElement(document.querySelector(`${panel} .q-uploader`)).pickFiles();
  },
  stop(target) {
    jauspy.release_keys();
    jauspy.gamepad?.forget();
    if (jauspy.stopSocket?.readyState === WebSocket.OPEN) {
      jauspy.stopSocket.send(`stop ${target}`);
      jauspy.say(jauspy._("stopping …"));
      clearTimeout(jauspy.unconfirmed);
      jauspy.unconfirmed = setTimeout(() => jauspy.say(jauspy._("NOT CONFIRMED: the console does not answer; stop the robot by other means")), 3000);
    } else {
      jauspy.say(jauspy._("NOT STOPPED: no connection to the console; stop the robot by other means"));
    }
  },
  clear(target) {
    jauspy.stopSocket?.send(`release ${target}`);
  },
  leave() {
    jauspy.stopSocket?.send("leave");
  },
  say(text) {
    const line = document.getElementById("stop-answer");
    if (line) line.textContent = text;
  },

  // Whether this page operates the robot, as the panel Control tells when it changes.
  operates: false,
  operate(now) {
    jauspy.operates = now;
    jauspy.release_keys(); // what is held when control comes or goes must be pressed again
    jauspy.gamepad?.forget();
    if (now) jauspy.answerDrive("");
  },
  answerDrive(text) {
    const line = document.getElementById("drive-answer");
    if (line && line.textContent !== text) line.textContent = text;
  },

  // --- driving: keys, stick, gamepad; 20 messages a second while something is deflected --------------------------
  keys: new Set(),
  stick: { forward: 0, left: 0, held: false },
  moving: false,
  bindings: {
    KeyW: [1, 0], ArrowUp: [1, 0], KeyS: [-1, 0], ArrowDown: [-1, 0],
    KeyA: [0, 1], ArrowLeft: [0, 1], KeyD: [0, -1], ArrowRight: [0, -1],
  },
  keep(chosen) {
    try {
      sessionStorage.setItem("jauspy-robot", chosen);
    } catch { /* this browser keeps nothing */ }
  },
  // Show a robot, 0 for none. What the operator has chosen is kept for this tab, so that it is shown after a reload.
  selectRobot(id, chosen) {
    if (chosen) jauspy.keep(JSON.stringify(chosen));
    if (jauspy.robot === id) return;
    jauspy.release_keys();
    jauspy.robot = id;
    jauspy.driveSocket?.close();
    jauspy.driveSocket = null;
    if (id) jauspy.connectDrive();
  },
  connectDrive() {
    if (!jauspy.robot) return;
    const socket = new WebSocket(jauspy.url(`drive/${jauspy.robot}`));
    socket.onmessage = (event) => jauspy.answerDrive(event.data);
    socket.onclose = () => {
      if (jauspy.driveSocket === socket) setTimeout(jauspy.connectDrive, 500);
    };
    jauspy.driveSocket = socket;
  },
  deflection() {
    let forward = jauspy.stick.forward;
    let left = jauspy.stick.left;
    for (const code of jauspy.keys) {
      forward += jauspy.bindings[code][0];
      left += jauspy.bindings[code][1];
    }
    const [ahead, aside] = jauspy.gamepad?.drive() ?? [0, 0];
    forward += ahead;
    left += aside;
    const clamp = (value) => Math.max(-1, Math.min(1, value));
    return [clamp(forward), clamp(left)];
  },
  tick() {
    if ((jauspy.keys.size || jauspy.stick.held) && jauspy.isSomethingOpen()) { jauspy.release_keys(); return; }
    const [forward, left] = jauspy.deflection();
    const moving = forward !== 0 || left !== 0;
    if ((moving || jauspy.moving) && jauspy.driveSocket?.readyState === WebSocket.OPEN) {
      jauspy.driveSocket.send(JSON.stringify([forward, left]));
    }
    jauspy.moving = moving;
    const knob = document.getElementById("stick-knob");
    const reach = knob ? (knob.parentElement.clientWidth - knob.clientWidth) / 2 : 0;
    if (knob) knob.style.transform = `translate(${-left * reach}px, ${-forward * reach}px)`;
  },
  release_keys() {
    jauspy.keys.clear();
    jauspy.stick = { forward: 0, left: 0, held: false };
    jauspy.tick();
  },
  // Drop-downs and dialogues, but none that is closing already: while one is open, keys move nothing, and Escape closes it.
  isSomethingOpen: () => jauspy.whatIsOpen() !== undefined,
  whatIsOpen: () => [...document.querySelectorAll(":is(.q-menu, .q-dialog__inner):not([class*='-leave-active']), dialog[open]")].at(-1),
  // True for a key that is none of a text, of the browser, or of what is open.
  isForPage(event) {
    const { target } = event;
    return !event.ctrlKey && !event.altKey && !event.metaKey && !target.closest?.("input, textarea, select, [contenteditable]") && !jauspy.isSomethingOpen();
  },
  // The letter on a key, in lower case; empty for the keys that drive. These are bound by their place, so that on a keyboard
  // whose key Q drives, what Q does is done by the key at the place of Q; and so are letters that are not Latin.
  letter({ key = "", code = "" }) {
    if (code in jauspy.bindings) return "";
    const letter = key.toLowerCase();
    return /^[b-z]$/.test(letter) && !"wsd".includes(letter) ? letter : code.startsWith("Key") ? code.slice(3).toLowerCase() : "";
  },
  // What is on the keys at the places of W, A, S, D and Q, as far as the browser tells; else as on most keyboards of the language.
  keyNames: { W: "W", A: "A", S: "S", D: "D", Q: "Q" },
  named: (text) => text.replace("W A S D", [..."WASD"].map((place) => jauspy.keyNames[place]).join(" ")),
  async nameKeys() {
    const layout = await navigator.keyboard?.getLayoutMap?.().catch(() => null);
    const usual = document.documentElement.lang.startsWith("fr") ? { W: "Z", A: "Q", S: "S", D: "D", Q: "A" } : jauspy.keyNames;
    for (const place of Object.keys(usual)) jauspy.keyNames[place] = (layout?.get(`Key${place}`) || usual[place]).toUpperCase();
    for (const element of document.querySelectorAll("[data-keys]")) {
      if (!element.childElementCount) element.textContent = jauspy.named(element.textContent);
      const label = element.getAttribute("aria-label");
      if (label) element.setAttribute("aria-label", jauspy.named(label));
    }
    document.querySelector(".acknowledge")?.setAttribute("title", jauspy._("key {key}; it also ends the sound", { key: jauspy.keyNames.Q }));
  },
  HAVE_ARROWS: ["slider", "separator", "tab", "menu", "group", "radiogroup", "listbox"].map((role) => `[role=${role}]`).join(", ") + ", .q-btn-toggle",
  // Escape does only this if it can; else it stops. The rest of one long press then does nothing. F8 always stops.
  closing: { what: undefined, time: 0, now: false }, // what Escape has closed, when, and whether that is the present press
  closeByEscape({ repeat, target, timeStamp }) {
    if (repeat) return jauspy.closing.now;
    const [what, before] = [jauspy.whatIsOpen(), jauspy.closing];
    const isClosing = what && what === before.what && timeStamp - before.time < 1000; // the page has not got round to it
    const now = what ? !isClosing : jauspy.leaveField(target) || jauspy.mission?.cancelArea() || jauspy.video?.closeSettings();
    jauspy.closing = { what, time: timeStamp, now };
    return now;
  },
  leaveField(field) {
    const leaves = field.matches?.("input:read-write, textarea:read-write") && field.value !== "";
    if (leaves) field.blur();
    return leaves;
  },
  listenToKeys() {
    addEventListener("keydown", (event) => {
      if (event.code === "F8" || (event.code === "Escape" && !jauspy.closeByEscape(event))) { jauspy.stop("all"); event.preventDefault(); return; }
      if (event.key?.startsWith("Arrow") && event.target.closest?.(jauspy.HAVE_ARROWS)) return;
      if (!(event.code in jauspy.bindings) || !jauspy.isForPage(event)) return;
      event.preventDefault();
      if (event.repeat) return; // a key that was released for its user, as by a stop, moves nothing until it is pressed again
      jauspy.keys.add(event.code);
      jauspy.tick();
    });
    addEventListener("keyup", (event) => { if (jauspy.keys.delete(event.code)) jauspy.tick(); });
    // While Meta is held, macOS tells of no other key that is released.
    for (const name of ["keydown", "keyup"]) addEventListener(name, (event) => event.key === "Meta" && jauspy.release_keys());
    for (const name of ["blur", "pagehide"]) addEventListener(name, jauspy.release_keys);
    document.addEventListener("visibilitychange", () => document.hidden && jauspy.release_keys());
    document.addEventListener("pointerdown", (event) => {
      const stick = event.target.closest?.("#stick");
      if (!stick) return;
      stick.setPointerCapture(event.pointerId);
      jauspy.stick.held = true;
      jauspy.moveStick(stick, event);
    });
    document.addEventListener("pointermove", (event) => {
      const stick = event.target.closest?.("#stick");
      if (stick && jauspy.stick.held) jauspy.moveStick(stick, event);
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
      document.addEventListener(name, () => {
        if (jauspy.stick.held) { jauspy.stick = { forward: 0, left: 0, held: false }; jauspy.tick(); }
      });
    }
    setInterval(jauspy.tick, 50);
  },
  moveStick(stick, event) {
    const box = stick.getBoundingClientRect();
    const scale = (at, from, size) => Math.max(-1, Math.min(1, (2 * (at - from)) / size - 1));
    jauspy.stick.left = -scale(event.clientX, box.left, box.width);
    jauspy.stick.forward = -scale(event.clientY, box.top, box.height);
    jauspy.tick();
  },

  // --- colours: as the system has them, or as chosen; this browser remembers --------------------------------------
  scheme() {
    const chosen = localStorage.getItem("jauspy-scheme");
    return chosen === "light" || chosen === "dark" ? chosen : "system";
  },
  showScheme() {
    const button = document.getElementById("scheme");
    const [sign, name] = { system: ["◐", jauspy._("system")], light: ["☀", jauspy._("light")], dark: ["☾", jauspy._("dark")] }[jauspy.scheme()];
    button.textContent = `${sign} ${name}`;
    button.setAttribute("aria-label", jauspy._("colours: {name}", { name }));
  },
  nextScheme() {
    const names = ["system", "light", "dark"];
    localStorage.setItem("jauspy-scheme", names[(names.indexOf(jauspy.scheme()) + 1) % names.length]);
    emitEvent("scheme", jauspy.scheme());
    jauspy.showScheme();
  },
  restore() {
    if (!window.did_handshake || !document.getElementById("scheme")) { setTimeout(jauspy.restore, 100); return; }
    jauspy.showScheme();
    jauspy.nameKeys();
    if (jauspy.scheme() !== "system") emitEvent("scheme", jauspy.scheme());
    if (jauspy.chosenBefore) emitEvent("remembered", jauspy.chosenBefore);
  },

  // --- sliders: what Quasar gives the focus has neither role nor name; it gets those of the slider around it ---------
  nameSliders() {
    for (const slider of document.querySelectorAll(".q-slider")) {
      const focused = slider.querySelector(".q-slider__track-container");
      focused.setAttribute("role", "slider");
      slider.setAttribute("role", "group");
      for (const { name, value } of slider.attributes) {
        if (name.startsWith("aria-")) focused.setAttribute(name, value);
      }
    }
  },
  watchSliders() {
    let planned = false;
    const observer = new MutationObserver(() => {
      if (planned) return;
      planned = true;
      setTimeout(() => {
        planned = false;
        jauspy.nameSliders();
        observer.takeRecords(); // of these changes
      }, 100);
    });
    observer.observe(document.body, { childList: true, subtree: true, attributeFilter: ["aria-valuenow", "aria-label"] });
  },

  start(token) {
    jauspy.token = token;
    jauspy.connectStop();
    jauspy.keepClicks();
    jauspy.listenToButtons();
    jauspy.listenToKeys();
    jauspy.watchSliders();
    try {
      jauspy.chosenBefore = sessionStorage.getItem("jauspy-robot");
    } catch { /* this browser keeps nothing */ }
    jauspy.restore();
    addEventListener("pagehide", jauspy.leave);
    addEventListener("pageshow", (event) => event.persisted && location.reload());
  },
};
jauspy.start(document.currentScript.dataset.token);
