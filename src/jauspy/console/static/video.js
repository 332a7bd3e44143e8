// Video: encoded pictures by WebSocket, decoded by WebCodecs, drawn on a canvas, with an overlay of the robot's attitude.
"use strict";

jauspy.video = {
  QUIET_TIME: 3000, // ms without a picture after which the page says why
  STALE_TIME: 1500, // ms after which a picture that is shown is marked as old
  FREEZE_TIME: 500, // ms without a new picture that are told when it comes
  MAX_DECODING: 6, // pictures in the decoder; more are left out until the next key picture
  MAX_LATE: 300, // ms by which a picture may be drawn later than the quickest one of its camera, before fewer are asked for
  MAX_LATE_LARGE: 1000, // the same of the large camera alone: its key pictures, one in 2 s, are 1 s old on average
  views: new Map(),
  level: 0, // 0: all pictures, 1: key pictures only of small cameras, 2: of all cameras
  frameRate: 60,
  onShown: null, // called with canvas and time stamp (us) when a picture was drawn

  watchAll() {
    const { views } = jauspy.video;
    for (const [canvas, view] of views) {
      if (!canvas.isConnected) { view.close(); views.delete(canvas); }
    }
    for (const canvas of document.querySelectorAll("canvas[data-component]")) {
      if (!views.has(canvas)) views.set(canvas, new jauspy.View(canvas));
      views.get(canvas).update();
    }
    jauspy.video.tellAge();
  },

  // Why this browser decodes nothing at all, or an empty string.
  missingDecoder() {
    if ("VideoDecoder" in window) return "";
    return window.isSecureContext
      ? jauspy._("no picture: this browser has no WebCodecs; Chromium 94, Firefox 130 and Safari 16.4 have it")
      : jauspy._("no picture: browsers decode video only on pages from localhost or by TLS, and this one came from {address}; use an SSH tunnel or TLS", { address: `http://${location.host}` });
  },

  frames: 0,
  slow: 0,
  fine: 0,
  recovery: 5,
  countFrame() {
    jauspy.video.frames += 1;
    if (jauspy.video.watching().length) requestAnimationFrame(jauspy.video.countFrame);
    else setTimeout(jauspy.video.countFrame, 500);
  },
  watching: () => [...jauspy.video.views.values()].filter((view) => view.wanted !== "nothing"),
  // How late the operator sees pictures decides how many the page asks for: fewer of the small cameras first.
  judge(seconds) {
    const video = jauspy.video;
    video.frameRate = video.frames / seconds;
    video.frames = 0;
    const watching = video.watching();
    if (document.hidden || !watching.length) { video.slow = video.fine = 0; return; }
    const large = watching.filter((view) => jauspy.isLarge(view.figure));
    const lag = (views) => Math.max(0, ...views.map((view) => view.lateNow));
    const leavesOut = (views) => views.some((view) => view.leftOutNow > 0);
    const [late, lateLarge] = [lag(watching), lag(large)];
    const small = video.level === 0 && watching.length > large.length; // these come first
    const tooSlow = small ? late > video.MAX_LATE || leavesOut(watching) : lateLarge > video.MAX_LATE_LARGE || leavesOut(large);
    const isFine = late <= video.MAX_LATE && !leavesOut(watching);
    for (const view of watching) view.leftOutNow = view.lateNow = 0;
    video.slow = tooSlow ? video.slow + 1 : 0;
    video.fine = isFine ? video.fine + 1 : 0;
    if (video.slow >= 3 && video.level < 2) {
      video.level = small ? 1 : 2;
      video.slow = 0;
      video.recovery = Math.min(30, 2 * video.recovery);
    } else if (video.fine >= video.recovery && video.level > 0) {
      video.level -= 1;
      video.fine = 0;
    }
    const why = tooSlow || !isFine ? jauspy._("pictures are {delay} ms late", { delay: Math.round(late) }) : jauspy._("pictures were late");
    const words = ["", jauspy._("{why}: small cameras show key pictures only", { why }), jauspy._("{why}: all cameras show key pictures only", { why })][video.level];
    const line = document.getElementById("video-load");
    if (line && line.textContent !== words) line.textContent = words;
  },
  // In the line below the bar: how old the large picture is; and an alarm of the page when it is too old.
  wasOld: false,
  tellAge() {
    const large = jauspy.video.watching().find((view) => jauspy.isLarge(view.figure));
    const line = document.getElementById("video-age");
    const old = large?.figure.classList.contains("stale") ?? false;
    if (line) {
      const age = large?.age();
      line.textContent = age === undefined ? "" : age < 10_000 ? jauspy._("video {age} ms", { age: Math.round(age) }) : jauspy._("video {age} s old", { age: Math.round(age / 1000) });
      line.toggleAttribute("data-old", old);
    }
    if (old !== jauspy.video.wasOld && window.did_handshake) emitEvent("video_is_old", old);
    jauspy.video.wasOld = old;
  },

  // Close the column of the camera's settings; true if it was shown, and the server is not closing it already.
  closeSettings() {
    const now = performance.now();
    if (!document.querySelector(".video-settings")?.offsetParent || now - (jauspy.video.settingsClosed ?? -Infinity) < 1000) return false;
    jauspy.video.settingsClosed = now;
    emitEvent("camera_settings_closed");
    return true;
  },

  ageText: (age) => (age < 10_000 ? `${Math.round(age)} ms` : `${Math.round(age / 1000)} s`),

  save(component, name) {
    const canvas = document.querySelector(`canvas[data-component="${component}"]`);
    canvas?.toBlob((content) => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(content);
      link.download = name;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    }, "image/png");
  },
};

// One camera on the page.
jauspy.View = class {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.figure = canvas.closest("figure");
    this.note = this.figure.querySelector(".video-note");
    this.facts = this.figure.querySelector(".video-facts");
    this.says = this.figure.querySelector(".video-says"); // what the camera says, as that its machine is too slow
    this.overlay = new jauspy.Overlay(this.figure.querySelector(".overlay"));
    this.shown = this.leftOut = this.leftOutByServer = 0;
    this.leftOutNow = this.lateNow = 0; // pictures, and ms of the latest one, since the page was last judged
    this.quickest = Infinity; // ms from when a picture was taken, by the robot's clock, until it was drawn
    this.times = [];
    this.freezes = []; // when a picture came after a long time without one, and this time, both in ms
    this.link = { missing: 0, lost: 0 }; // parts of the packets that did not arrive, and that were not restored either
    this.reason = this.cameraNote = "";
    this.began = performance.now();
    this.wanted = "all";
    this.skipping = false;
    this.problem = jauspy.video.missingDecoder();
    if (!this.problem) this.connect();
  }

  connect() {
    const socket = new WebSocket(jauspy.url(`video/${this.canvas.dataset.component}`));
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.told = "";
    this.leftOutByServer = 0;
    this.quickest = Infinity;
    this.cameraNote = "";
    this.link = { missing: 0, lost: 0 };
    socket.onmessage = (event) => (typeof event.data === "string" ? this.news(JSON.parse(event.data)) : this.decode(event.data));
    socket.onclose = (event) => {
      this.stopDecoding();
      this.reason = event.reason || jauspy._("no connection to the console");
      if (!this.closed) this.retry = setTimeout(() => this.connect(), 1000);
    };
  }

  close() {
    this.closed = true;
    clearTimeout(this.retry);
    this.socket?.close();
    this.stopDecoding();
  }

  stopDecoding() {
    if (this.decoder && this.decoder.state !== "closed") this.decoder.close();
    this.decoder = null;
  }

  news(news) {
    if ("reason" in news) this.reason = news.reason;
    if ("note" in news) this.cameraNote = news.note;
    if ("left_out" in news) {
      this.leftOutNow += news.left_out - this.leftOutByServer;
      this.leftOutByServer = news.left_out;
    }
    if (news.link) this.link = news.link;
    if (news.attitude) this.overlay.show(news.attitude);
    if (news.codec) this.configure(news.codec);
  }

  configure(codec) {
    this.stopDecoding();
    this.problem = "";
    this.decoder = new VideoDecoder({
      output: (frame) => this.draw(frame),
      error: (error) => { this.problem = jauspy._("no picture: this browser cannot decode the video ({codec}): {error}", { codec, error: error.message }); },
    });
    try {
      this.decoder.configure({ codec, optimizeForLatency: true });
    } catch (error) {
      this.problem = jauspy._("no picture: this browser does not know the coding {codec}: {error}", { codec, error: error.message });
    }
    this.skipping = false;
  }

  // A picture: whether it is a key picture, its time stamp, when it was taken (ms since 1970 of the robot), and its bytes.
  decode(data) {
    if (this.decoder?.state !== "configured") return;
    const header = new DataView(data, 0, 24);
    const key = header.getUint8(0) === 1;
    if (key) this.skipping = false;
    else if (this.decoder.decodeQueueSize > jauspy.video.MAX_DECODING) this.skipping = true;
    if (this.skipping) {
      this.leftOut += 1;
      this.leftOutNow += 1;
      return;
    }
    const timestamp = header.getFloat64(8, true);
    this.taken ??= new Map();
    this.taken.set(Math.round(timestamp), header.getFloat64(16, true));
    if (this.taken.size > 64) this.taken.delete(this.taken.keys().next().value);
    this.decoder.decode(new EncodedVideoChunk({ type: key ? "key" : "delta", timestamp, data: new Uint8Array(data, 24) }));
  }

  draw(frame) {
    const { canvas } = this;
    if (canvas.width !== frame.displayWidth || canvas.height !== frame.displayHeight) {
      canvas.width = frame.displayWidth;
      canvas.height = frame.displayHeight;
    }
    this.context.drawImage(frame, 0, 0);
    const { timestamp } = frame;
    frame.close();
    this.shown += 1;
    this.takenAt = this.taken.get(Math.round(timestamp));
    this.taken.delete(Math.round(timestamp));
    const before = this.drawnAt;
    this.drawnAt = performance.now();
    if (before > this.allSince && this.drawnAt - before > jauspy.video.FREEZE_TIME) this.freezes.push([this.drawnAt, this.drawnAt - before]);
    this.measure();
    this.times.push(this.drawnAt);
    if (this.times.length > 200) this.times.shift();
    canvas.dataset.pictures = this.shown;
    this.reason = "";
    jauspy.video.onShown?.(canvas, this.takenAt);
  }

  // How late this picture was drawn. The clocks of robot and browser may differ, so the quickest picture is the measure.
  measure() {
    if (!(this.takenAt > 0)) return;
    const delay = Date.now() - this.takenAt;
    this.quickest = Math.min(this.quickest, delay);
    this.lateNow = Math.max(this.lateNow, delay - this.quickest);
    this.delay = delay - (this.quickest > -50 && this.quickest < 2000 ? 0 : this.quickest);
  }

  // ms since what is shown was taken, as far as the clocks agree; undefined before the first picture.
  age() {
    if (this.drawnAt === undefined) return undefined;
    const since = performance.now() - this.drawnAt;
    return since > jauspy.video.STALE_TIME ? since + (this.delay ?? 0) : Math.max(0, this.delay ?? since);
  }

  // Twice a second: what is wanted of the server, and what is said about the picture.
  update() {
    const video = jauspy.video;
    const large = jauspy.isLarge(this.figure);
    const visible = !document.hidden && this.canvas.offsetParent !== null;
    const few = video.level > (large ? 1 : 0);
    this.wanted = visible ? (few ? "keys" : "all") : "nothing";
    if (this.wanted !== "all") this.allSince = Infinity;
    else if (!(this.allSince < Infinity)) this.allSince = performance.now();
    if (!visible) this.began = performance.now();
    const ask = JSON.stringify({ want: this.wanted, attitude: visible && large && !this.figure.closest(".plain") });
    if (this.socket?.readyState === WebSocket.OPEN && ask !== this.told) {
      this.socket.send(ask);
      this.told = ask;
    }
    if (visible) this.say();
  }

  say() {
    const now = performance.now();
    while (this.times.length && this.times[0] < now - 2000) this.times.shift();
    const age = now - (this.drawnAt ?? this.began);
    const stale = this.drawnAt !== undefined && age > (this.wanted === "keys" ? 5000 : jauspy.video.STALE_TIME);
    let words = this.problem;
    if (!words && this.drawnAt === undefined) {
      words = age < jauspy.video.QUIET_TIME ? jauspy._("waiting for the camera …") : jauspy._("no picture: {reason}", { reason: this.reason || jauspy._("pictures arrive, and none could be decoded yet") });
    } else if (!words && stale) {
      words = jauspy._("this picture is {age} s old", { age: Math.round(age / 1000) }) + (this.reason ? `: ${this.reason}` : "");
    }
    if (this.note.textContent !== words) this.note.textContent = this.note.title = words;
    this.figure.classList.toggle("stale", stale);
    const note = this.drawnAt === undefined ? "" : this.cameraNote; // before a picture, it is the reason
    if (this.says.textContent !== note) this.says.textContent = this.says.title = note;
    const facts = [];
    if (this.takenAt > 0 && jauspy.isLarge(this.figure)) facts.push(new Date(this.takenAt).toTimeString().slice(0, 8));
    if (this.drawnAt !== undefined) facts.push(`${Math.round(this.times.length / 2)}/s`);
    if (this.drawnAt !== undefined && this.takenAt > 0) facts.push(jauspy.video.ageText(this.age()));
    facts.push(...this.linkTexts(now));
    const leftOut = this.leftOut + this.leftOutByServer;
    if (leftOut) facts.push(jauspy._("{count} left out", { count: leftOut }));
    this.facts.textContent = facts.join("  ·  ");
    this.facts.toggleAttribute("data-poor", this.link.lost > 0 || this.freezes.length > 0);
  }

  // What the link has done to the video in the last 10 s.
  linkTexts(now) {
    while (this.freezes.length && this.freezes[0][0] < now - 10_000) this.freezes.shift();
    const { missing, lost } = this.link;
    const percent = (part) => (100 * part).toFixed(part < 0.0995 ? 1 : 0);
    const texts = [];
    if (lost > 0) texts.push(jauspy._("{missing} % lost, {lost} % for good", { missing: percent(missing), lost: percent(lost) }));
    else if (missing > 0) texts.push(jauspy._("{missing} % lost, all restored", { missing: percent(missing) }));
    const longest = Math.max(0, ...this.freezes.map(([, time]) => time));
    if (longest) texts.push(jauspy._("stood still for {seconds} s", { seconds: (longest / 1000).toFixed(1) }));
    return texts;
  }
};

jauspy.isLarge = (figure) => figure.classList.contains("large") || (!figure.parentElement.querySelector(".large") && figure === figure.parentElement.querySelector("figure"));

// Heading as a tape, pitch and roll as an artificial horizon, speed as a number.
jauspy.Overlay = class {
  constructor(element) {
    const ticks = [];
    for (let angle = -60; angle <= 420; angle += 5) {
      const x = 4 * angle;
      const long = angle % 10 === 0;
      ticks.push(`<path d="M${x} 0v${long ? 9 : 5}"/>`);
      if (angle % 30 === 0) ticks.push(`<text data-heading="${angle}" x="${x}" y="22"></text>`);
    }
    const ladder = [-20, -10, 10, 20].map((angle) => `<path d="M${angle % 20 ? -9 : -14} ${-1.4 * angle}h${angle % 20 ? 18 : 28}"/>`).join("");
    element.innerHTML = `
      <svg class="tape" role="img" viewBox="-160 0 320 46"><g class="scale">${ticks.join("")}</g>
        <path class="mark" d="M0 24l-5 6h10z"/><text class="number" x="0" y="45"></text></svg>
      <svg class="dial" role="img" viewBox="-46 -46 92 92"><g class="turn"><g class="lift">
        <rect class="sky" x="-90" y="-160" width="180" height="160"/><rect class="ground" x="-90" y="0" width="180" height="160"/>
        <path d="M-90 0h180"/>${ladder}</g></g><path class="wings" d="M-26 0h14l5 5M26 0h-14l-5 5"/><circle r="44"/></svg>
      <div class="numbers"><b></b><span></span></div>`;
    this.parts = Object.fromEntries(["scale", "number", "turn", "lift", "tape", "dial"].map((name) => [name, element.querySelector(`.${name}`)]));
    this.parts.tape.setAttribute("aria-label", jauspy._("heading"));
    this.parts.dial.setAttribute("aria-label", jauspy._("artificial horizon"));
    this.speed = element.querySelector("b");
    this.angles = element.querySelector("span");
    this.element = element;
  }

  // The heading, in degrees clockwise, in the axes and the unit of this page.
  headingText(heading) {
    if (document.body.dataset.axes !== "JAUS") return jauspy.settings.angle(180 - ((((heading + 180) % 360) + 360) % 360));
    const text = jauspy.settings.angle((heading + 360) % 360);
    return text === jauspy.settings.angle(360) ? jauspy.settings.angle(0) : text;
  }
  showTicks() {
    const { axes, angle } = document.body.dataset;
    if (this.chosen === axes + angle) return;
    this.chosen = axes + angle;
    for (const tick of this.element.querySelectorAll("[data-heading]")) tick.textContent = this.headingText(Number(tick.dataset.heading)).replace(/°| rad/, "");
  }
  // Degrees: heading clockwise, pitch up, roll to the right; speed in m/s. What the robot does not report is null.
  show(attitude) {
    this.shown = attitude;
    this.refresh();
  }
  refresh() {
    if (!this.shown) return;
    const { heading, pitch, roll, speed } = this.shown;
    const { scale, number, turn, lift, tape, dial } = this.parts;
    const known = (value) => value !== null && value !== undefined;
    tape.style.display = known(heading) ? "" : "none";
    dial.style.display = known(pitch) && known(roll) ? "" : "none";
    if (known(heading)) {
      scale.setAttribute("transform", `translate(${-4 * heading})`);
      number.textContent = this.headingText(heading);
    }
    turn.setAttribute("transform", `rotate(${-(roll ?? 0)})`);
    lift.setAttribute("transform", `translate(0 ${1.4 * Math.max(-30, Math.min(30, pitch ?? 0))})`);
    const { length, angle } = jauspy.settings;
    const upwards = document.body.dataset.axes === "JAUS" ? 1 : -1; // REP-103 counts pitch downwards
    this.showTicks();
    this.speed.textContent = known(speed) ? length(speed, 1, "/s") : "";
    this.angles.textContent = known(pitch) && known(roll) ? jauspy._("pitch {pitch}, roll {roll}", { pitch: angle(upwards * pitch), roll: angle(roll) }) : "";
    this.element.dataset.known = "yes";
  }
};

setInterval(jauspy.video.watchAll, 500);
jauspy.video.judging = setInterval(() => jauspy.video.judge(2), 2000);
requestAnimationFrame(jauspy.video.countFrame);
