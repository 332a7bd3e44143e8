// Moving the tool of an arm while a button or key is held, on a connection of its own; console.js is loaded before.
"use strict";

jauspy.jog = {
  socket: null,
  component: "",
  moving: false,
  held: new Map(), // what is held, a pointer or a key, to [axis, sign]
  keys: { i: [0, 1], k: [0, -1], j: [1, 1], l: [1, -1], u: [2, 1], o: [2, -1] },

  pad() {
    const pad = document.querySelector(".jog[data-component]");
    return pad && pad.offsetParent !== null && pad.dataset.component ? pad : null;
  },
  connect(component) {
    const jog = jauspy.jog;
    if (jog.component === component) return;
    jog.release();
    jog.component = component;
    jog.socket?.close();
    jog.socket = null;
    if (!component) return;
    const socket = new WebSocket(jauspy.url(`jog/${component}`));
    socket.onmessage = (event) => {
      const line = document.querySelector(".jog-answer");
      if (line) line.textContent = event.data;
    };
    socket.onclose = () => {
      if (jog.socket === socket) setTimeout(() => { if (jog.socket === socket) jog.component = ""; }, 500);
    };
    jog.socket = socket;
  },
  tick() {
    const jog = jauspy.jog;
    const pad = jog.pad();
    jog.connect(pad?.dataset.component ?? "");
    if (!pad) return;
    if (jog.held.size && jauspy.isSomethingOpen()) jog.held.clear();
    const velocity = [0, 0, 0, 0, 0, 0];
    for (const [axis, sign] of jog.held.values()) velocity[axis] += sign;
    const shares = jauspy.gamepad?.arm() ?? [];
    for (let axis = 0; axis < 6; axis += 1) {
      const share = Math.max(-1, Math.min(1, Math.sign(velocity[axis]) + (shares[axis] ?? 0)));
      velocity[axis] = share * Number(axis < 3 ? pad.dataset.linear : pad.dataset.angular);
    }
    const moving = velocity.some((each) => each !== 0);
    if ((moving || jog.moving) && jog.socket?.readyState === WebSocket.OPEN) {
      jog.socket.send(JSON.stringify([...velocity, pad.dataset.frame]));
    }
    jog.moving = moving;
    for (const button of pad.querySelectorAll(".jog-button")) {
      button.classList.toggle("pressed", velocity[button.dataset.axis] * button.dataset.sign > 0);
    }
  },
  release() {
    jauspy.jog.held.clear();
    if (jauspy.jog.moving) jauspy.jog.tick();
  },
  listen() {
    const jog = jauspy.jog;
    addEventListener("keydown", (event) => {
      if (["Escape", "Shift", "Meta"].includes(event.key)) { jog.release(); return; }
      const letter = jauspy.letter(event);
      if (event.repeat || !(letter in jog.keys) || !jauspy.isForPage(event) || !jog.pad()) return;
      const [axis, sign] = jog.keys[letter];
      jog.held.set(event.code, [axis + (event.shiftKey ? 3 : 0), sign]);
      event.preventDefault();
      jog.tick();
    });
    addEventListener("keyup", (event) => {
      if (event.key === "Shift" || event.key === "Meta") { jog.release(); return; }
      if (jog.held.delete(event.code)) jog.tick();
    });
    document.addEventListener("pointerdown", (event) => {
      const button = event.target.closest?.(".jog-button");
      if (!button || event.button !== 0) return;
      button.setPointerCapture(event.pointerId);
      jog.held.set(`pointer ${event.pointerId}`, [Number(button.dataset.axis), Number(button.dataset.sign)]);
      jog.tick();
    });
    for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
      document.addEventListener(name, (event) => {
        if (jog.held.delete(`pointer ${event.pointerId}`)) jog.tick();
      });
    }
    document.addEventListener("contextmenu", (event) => {
      if (event.target.closest?.(".jog-button")) event.preventDefault(); // a long touch
    });
    for (const name of ["blur", "pagehide"]) addEventListener(name, jog.release);
    document.addEventListener("visibilitychange", () => document.hidden && jog.release());
    setInterval(jog.tick, 50);
  },
};
jauspy.jog.listen();
