// What this browser keeps about the view (axes and units), the help about keys, and sliders that follow fast presses.
"use strict";

jauspy.settings = {
  KEY: "jauspy-view",
  DEFAULTS: { axes: "REP-103", length: "m", angle: "deg" },
  KEYS: [
    [jauspy._("Driving"), [
      [jauspy._("W A S D, arrows"), jauspy._("drive while held; the robot brakes when the key is released")],
      [jauspy._("stick, gamepad"), jauspy._("drive; a gamepad drives while its enable button is held")],
    ]],
    [jauspy._("The tool of an arm (panel Arm, tool)"), [["I K", jauspy._("forward, backward")], ["J L", jauspy._("left, right")], ["U O", jauspy._("up, down")], ["Shift", jauspy._("with these keys: about these axes")]]],
    [jauspy._("Views and alarms"), [
      ["1 2 3 4", jauspy._("arrangements: one view, drive, arm, observe")],
      ["F", jauspy._("the view that was used last in all of the window, and again the others")],
      [jauspy._("arrows"), jauspy._("move the line between views that has the focus")],
      ["Q", jauspy._("acknowledge the alarms")],
    ]],
    [jauspy._("Everywhere"), [
      ["Esc", jauspy._("stop all robots; closes what is open first")],
      ["F8", jauspy._("stop all robots, always")],
      ["Tab", jauspy._("the next button or field")],
      ["?", jauspy._("this help")],
    ]],
  ],

  read() {
    try {
      const kept = JSON.parse(localStorage.getItem(jauspy.settings.KEY));
      return { ...jauspy.settings.DEFAULTS, ...(typeof kept === "object" ? kept : {}) };
    } catch {
      return jauspy.settings.DEFAULTS; // this browser keeps nothing
    }
  },
  keep(chosen) {
    try {
      localStorage.setItem(jauspy.settings.KEY, JSON.stringify(chosen));
    } catch { /* this browser keeps nothing */ }
    jauspy.settings.show(chosen);
  },
  // The page is built in one language: another one is kept in a cookie, for the next request of the page.
  speak(language) {
    document.cookie = `jauspy-language=${encodeURIComponent(language)}; path=/; max-age=31536000; samesite=strict`;
    location.reload();
  },
  show({ axes, length, angle }) {
    Object.assign(document.body.dataset, { axes, length, angle });
    jauspy.world.changed();
    for (const view of jauspy.video.views.values()) view.overlay.refresh();
  },
  // A length in metres, or a speed with `per` "/s", and an angle in degrees, in the units of this page.
  FOOT: 0.3048, // metres
  length(metres, digits, per = "") {
    const isFeet = document.body.dataset.length === "ft";
    const number = (isFeet ? metres / jauspy.settings.FOOT : metres).toFixed(digits);
    return `${jauspy.settings.signed(number)} ${isFeet ? "ft" : "m"}${per}`;
  },
  angle(degrees) {
    const number = document.body.dataset.angle === "rad" ? `${((degrees * Math.PI) / 180).toFixed(2)} rad` : `${Math.round(degrees)}°`;
    return jauspy.settings.signed(number);
  },
  signed: (text) => text.replace("-", /[1-9]/.test(text) ? "−" : ""),
  // The bar of a map: the shortest round length of at least `least` metres, in metres, and its text.
  scaleBar(least) {
    const unit = document.body.dataset.length === "ft" ? jauspy.settings.FOOT : 1;
    const count = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200].find((each) => each * unit > least) ?? 500;
    return { metres: count * unit, text: `${count} ${unit === 1 ? "m" : "ft"}` };
  },
  restore() {
    if (!window.did_handshake || !document.getElementById("scheme")) { setTimeout(jauspy.settings.restore, 100); return; }
    const chosen = jauspy.settings.read();
    jauspy.settings.show(chosen);
    if (JSON.stringify(chosen) !== JSON.stringify(jauspy.settings.DEFAULTS)) emitEvent("view", chosen);
  },

  // --- help: a dialogue of the browser's own, which Escape closes ------------------------------------------------------
  help() {
    const { make } = jauspy;
    let dialog = document.getElementById("key-help");
    if (!dialog) {
      const rows = jauspy.settings.KEYS.flatMap(([group, keys]) => [make("h3", {}, group), make("dl", {}, ...keys.flatMap(([key, what]) => [make("dt", {}, make("kbd", {}, jauspy.named(key))), make("dd", {}, what)]))]);
      dialog = make("dialog", { id: "key-help", "aria-label": jauspy._("keyboard help") }, make("h2", {}, jauspy._("Keys")), ...rows, make("button", { class: "quiet", onclick: () => dialog.close() }, jauspy._("close")));
      document.body.append(dialog);
    }
    if (!dialog.open) dialog.showModal();
  },
  // --- lists of lines follow what is new while their end is shown, also after somebody has scrolled up and back ------------
  NEAR: 24, // pixels from the end
  followEnds() {
    for (const list of document.querySelectorAll(".lines .q-scrollarea__container")) {
      if (list.dataset.follows) continue;
      list.dataset.follows = "yes";
      list.addEventListener("scroll", () => { list.dataset.follows = list.scrollHeight - list.scrollTop - list.clientHeight < jauspy.settings.NEAR ? "yes" : "no"; });
      new MutationObserver(() => { if (list.dataset.follows === "yes") list.scrollTop = list.scrollHeight; }).observe(list, { childList: true, subtree: true });
    }
  },
  listen() {
    setInterval(jauspy.settings.followEnds, 1000);
    jauspy.actions.help = jauspy.settings.help;
    addEventListener("keydown", (event) => {
      if (event.key !== "?" || event.ctrlKey || event.altKey || event.metaKey || event.target.closest?.("input, textarea, select")) return;
      event.preventDefault();
      jauspy.settings.help();
    });
  },
};
jauspy.settings.listen();
jauspy.settings.restore();
