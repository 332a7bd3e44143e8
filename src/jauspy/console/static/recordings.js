// The tab Recordings: the list of files, films, and recorded runs with video, map, values and events on one time axis.
"use strict";

// Makes an element; texts are data, never markup.
jauspy.make = (tag, attributes = {}, ...children) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "class") element.className = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== false && value !== null) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children);
  return element;
};

jauspy.recordings = {
  LIST_INTERVAL: 5000, // ms between two looks at the folder
  KINDS: { run: jauspy._("run"), film: jauspy._("film"), capture: jauspy._("capture, for Wireshark and jauspy decode"), sound: jauspy._("sound"), picture: jauspy._("picture") },
  listed: "",
  lookedAt: -Infinity,
  run: null,

  url: (what, name, query = "") => `/recordings/${jauspy.token}${what ? `/${what}/${encodeURIComponent(name)}` : ""}${query}`,
  async fetched(url) {
    let answer;
    try {
      answer = await fetch(url);
    } catch {
      throw new Error(jauspy._("no connection to the console"));
    }
    if (answer.ok) return answer;
    let said = "";
    try {
      said = (await answer.json()).detail;
    } catch { /* the console says no more */ }
    throw new Error(typeof said === "string" && said ? said : jauspy._("the console answers {status}", { status: answer.status }));
  },
  async watch() {
    const self = jauspy.recordings;
    const panel = document.getElementById("recordings");
    const visible = panel && panel.offsetParent !== null && !document.hidden;
    if (!visible) { self.run?.pause(); return; }
    self.run?.watchSize();
    if (performance.now() - self.lookedAt < self.LIST_INTERVAL) return;
    self.lookedAt = performance.now();
    try {
      self.showList(panel, await (await self.fetched(self.url())).json());
    } catch (error) {
      self.showList(panel, { folder: "", files: [], problem: error.message });
    }
  },
  showList(panel, found) {
    const self = jauspy.recordings;
    const text = JSON.stringify(found);
    if (text === self.listed) return;
    self.listed = text;
    const rows = found.files.map(({ name, kind, size, time }) => jauspy.make("li", { "data-name": name },
      jauspy.make("div", { class: "recorded-name", title: name }, name),
      jauspy.make("div", { class: "hint" }, `${self.KINDS[kind]} · ${self.size(size)} · ${new Date(1000 * time).toLocaleString()}`),
      jauspy.make("div", { class: "recorded-buttons" },
        ...(kind === "capture" ? [] : [jauspy.make("button", { class: "quiet", "aria-label": jauspy._("play {name}", { name }), onclick: () => self.open(name, kind) }, jauspy._("play"))]),
        jauspy.make("a", { class: "quiet", href: self.url("file", name), download: name, "aria-label": jauspy._("download {name}", { name }) }, jauspy._("download")))));
    const notes = [
      found.left_out && jauspy._("{count} older ones are not listed", { count: found.left_out }),
      found.misnamed && jauspy._("Not listed for their names: {count}. Names begin with a letter or digit, and have only these, spaces and . _ + @ , ( ) -", { count: found.misnamed }),
      found.others && jauspy._("Not listed as they are no recordings: {count}", { count: found.others }),
    ];
    const more = notes.filter(Boolean).map((note) => jauspy.make("p", { class: "hint" }, note));
    const empty = found.files.length ? [] : [jauspy.make("p", { class: "hint" }, found.problem ?? jauspy._("no recordings yet: record a camera in the tab Video, or a run with"), " ", ...(found.problem ? [] : [jauspy.make("code", {}, `jauspy record ${found.folder}/run.mcap`)]))];
    panel.querySelector(".recorded").replaceChildren(
      jauspy.make("div", { class: "heading" }, jauspy._("Recordings")), jauspy.make("div", { class: "hint folder" }, found.folder), ...empty, jauspy.make("ul", {}, ...rows), ...more);
    self.mark();
  },
  mark() {
    for (const row of document.querySelectorAll(".recorded li")) row.classList.toggle("chosen", row.dataset.name === jauspy.recordings.opened);
  },
  size: (bytes) => (bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : bytes < 1e9 ? `${(bytes / 1e6).toFixed(1)} MB` : `${(bytes / 1e9).toFixed(2)} GB`),

  async open(name, kind) {
    const self = jauspy.recordings;
    const player = document.querySelector("#recordings .player");
    self.run?.close();
    self.run = null;
    self.opened = name;
    self.mark();
    if (kind !== "run") {
      const [tag, more] = { sound: ["audio", { controls: true }], film: ["video", { controls: true }], picture: ["img", { alt: name }] }[kind];
      const media = jauspy.make(tag, { src: self.url("file", name), "aria-label": name, ...more });
      const problem = jauspy.make("p", { class: "problem", role: "status" });
      media.addEventListener("error", () => { problem.textContent = jauspy._("{name} cannot be played: this browser does not know its coding, or the file is damaged", { name }); });
      player.replaceChildren(jauspy.make("div", { class: "heading" }, name), media, problem);
      media.play?.()?.catch(() => {}); // the browser waits for a click, and shows its own button
      return;
    }
    player.replaceChildren(jauspy.make("p", { class: "hint", role: "status" }, jauspy._("reading {name} …", { name })));
    try {
      const run = await (await self.fetched(self.url("run", name))).json();
      if (self.opened !== name) return;
      self.run = new jauspy.Run(player, name, run);
    } catch (error) {
      if (self.opened === name) player.replaceChildren(jauspy.make("p", { class: "problem", role: "alert" }, error.message));
    }
  },
};

// One recorded run: a clock that all views follow.
jauspy.Run = class {
  constructor(player, name, run) {
    Object.assign(this, { name, run, time: 0, playing: false, rate: 1, chosen: [] });
    this.start = jauspy.make("button", { class: "quiet", onclick: () => (this.playing ? this.pause() : this.play()) }, jauspy._("play"));
    this.slider = jauspy.make("input", { type: "range", min: 0, max: run.seconds, step: 0.01, value: 0, "aria-label": jauspy._("time of the run in seconds"), oninput: () => this.seek(Number(this.slider.value)) });
    this.clock = jauspy.make("span", { class: "run-clock" });
    const speed = jauspy.make("select", { "aria-label": jauspy._("speed of playing"), onchange: () => { this.keepTime(); this.rate = Number(speed.value); } }, ...[0.25, 0.5, 1, 2, 4, 8].map((rate) => jauspy.make("option", { value: rate, selected: rate === 1 }, `${rate} ×`)));
    this.cameras = run.cameras.filter(({ times }) => times.length).map((camera) => new jauspy.RecordedCamera(this, camera));
    this.map = jauspy.make("canvas", { class: "run-map", role: "img", "aria-label": jauspy._("tracks of the robots") });
    this.map.addEventListener("click", (event) => this.seekOnMap(event));
    this.plot = jauspy.make("canvas", { class: "run-plot", role: "img", "aria-label": jauspy._("values over time") });
    this.plot.addEventListener("click", (event) => this.seek(run.seconds * ((event.offsetX - 46) / Math.max(1, this.plot.clientWidth - 56))));
    const add = jauspy.make("select", { "aria-label": jauspy._("add a value"), onchange: () => { this.choose(Number(add.value)); add.value = ""; } },
      jauspy.make("option", { value: "" }, run.series.length ? jauspy._("add a value …") : jauspy._("no values")), ...run.series.map((each, index) => jauspy.make("option", { value: index }, each.unit ? `${each.name} [${each.unit}]` : each.name)));
    this.chips = jauspy.make("div", { class: "chips" });
    this.events = run.events.map(([at, level, who, text]) => jauspy.make("button", { class: "run-event", "data-level": level, onclick: () => this.seek(at) }, jauspy.make("span", {}, this.shown(at)), jauspy.make("span", {}, text.startsWith(who) ? text : `${who} ${text}`)));
    this.eventList = jauspy.make("div", { class: "run-events", role: "region", tabindex: 0, "aria-label": jauspy._("events of the run") }, ...(this.events.length ? this.events : [jauspy.make("p", { class: "hint" }, jauspy._("no events"))]));
    const left = Object.entries(run.left_out).map(([what, many]) => `${many} ${what}`);
    player.replaceChildren(...[
      jauspy.make("div", { class: "row" }, jauspy.make("div", { class: "heading" }, name), jauspy.make("span", { class: "hint" }, left.length ? jauspy._("left out: {what}", { what: left.join(", ") }) : "")),
      jauspy.make("div", { class: "run-views", "data-cameras": Math.min(3, this.cameras.length) }, jauspy.make("div", { class: "run-cameras" }, ...this.cameras.map((camera) => camera.figure)), this.map),
      jauspy.make("div", { class: "run-bar" }, this.start, speed, this.slider, this.clock),
      jauspy.make("div", { class: "run-below" }, jauspy.make("div", { class: "run-values" }, jauspy.make("div", { class: "run-choice" }, add, this.chips), this.plot), this.eventList),
    ]);
    for (const wanted of [/VelocityState\.velocity_x$/, /VelocityState\.yaw_rate$/, /LocalPose\.x$/]) {
      const found = run.series.findIndex((each) => wanted.test(each.name));
      if (found >= 0 && this.chosen.length < 2) this.choose(found);
    }
    this.seek(0);
  }

  close() {
    this.pause();
    for (const camera of this.cameras) camera.close();
  }
  play() {
    if (this.time >= this.run.seconds) this.seek(0);
    this.playing = true;
    this.from = [performance.now(), this.time];
    this.start.textContent = jauspy._("pause");
    const step = () => {
      if (!this.playing) return;
      this.time = Math.min(this.run.seconds, this.from[1] + ((performance.now() - this.from[0]) / 1000) * this.rate);
      if (this.time >= this.run.seconds) this.pause();
      this.show();
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
  pause() {
    this.playing = false;
    this.start.textContent = jauspy._("play");
  }
  keepTime() {
    this.from = [performance.now(), this.time];
  }
  seek(time) {
    this.time = Math.max(0, Math.min(this.run.seconds, time));
    this.keepTime();
    this.show();
  }
  shown(time) {
    const seconds = Math.max(0, time);
    return `${Math.floor(seconds / 60)}:${(seconds % 60).toFixed(1).padStart(4, "0")}`;
  }
  show() {
    this.slider.value = this.time;
    this.slider.setAttribute("aria-valuetext", `${this.time.toFixed(1)} s`);
    this.clock.textContent = `${this.shown(this.time)} / ${this.shown(this.run.seconds)} · ${new Date(1000 * (this.run.start + this.time)).toLocaleTimeString()}`;
    for (const camera of this.cameras) camera.show(this.time);
    this.drawMap();
    this.drawPlot();
    let last = -1;
    while (last + 1 < this.run.events.length && this.run.events[last + 1][0] <= this.time) last += 1;
    if (last === this.lastEvent) return;
    this.events[this.lastEvent]?.classList.remove("now");
    this.lastEvent = last;
    const row = this.events[last];
    if (!row) { this.eventList.scrollTop = 0; return; }
    row.classList.add("now");
    this.eventList.scrollTop = row.offsetTop - this.eventList.offsetTop - this.eventList.clientHeight / 2;
  }
  watchSize() {
    const dark = document.body.classList.contains("body--dark");
    const changed = [this.map, this.plot].map((canvas) => this.fit(canvas)).some(Boolean);
    if (changed || dark !== this.dark) {
      this.dark = dark;
      this.drawMap();
      this.drawPlot();
    }
  }
  fit(canvas) {
    const ratio = Math.min(2, devicePixelRatio);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (!width || (canvas.width === width && canvas.height === height)) return false;
    [canvas.width, canvas.height] = [width, height];
    return true;
  }

  // --- the map: x to the right, y upwards ----------------------------------------------------------------------------
  place() {
    const points = Object.values(this.run.tracks).flat();
    if (!points.length) return null;
    this.bounds ??= [1, 2].map((axis) => points.reduce(([low, high], point) => [Math.min(low, point[axis]), Math.max(high, point[axis])], [Infinity, -Infinity]));
    const [[left, right], [bottom, top]] = this.bounds;
    const { width, height } = this.map;
    const scale = Math.min(width / Math.max(2, 1.2 * (right - left)), height / Math.max(2, 1.2 * (top - bottom)));
    return { scale, to: (x, y) => [width / 2 + (x - (left + right) / 2) * scale, height / 2 - (y - (bottom + top) / 2) * scale] };
  }
  at(track) {
    let [low, high] = [0, track.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (track[middle][0] <= this.time) low = middle; else high = middle - 1;
    }
    return low;
  }
  drawMap() {
    this.fit(this.map);
    const pen = this.map.getContext("2d");
    const colours = jauspy.world.colours();
    const ratio = Math.min(2, devicePixelRatio);
    pen.fillStyle = colours.ground;
    pen.fillRect(0, 0, this.map.width, this.map.height);
    pen.fillStyle = colours.quiet;
    pen.font = `${11 * ratio}px system-ui, sans-serif`;
    const place = this.place();
    if (!place) { pen.fillText(jauspy._("the run has no poses"), 10 * ratio, 20 * ratio); return; }
    const palette = jauspy.colours[colours.dark ? "dark" : "light"];
    const line = (points, colour, width) => {
      pen.strokeStyle = colour;
      pen.lineWidth = width * ratio;
      pen.lineJoin = "round";
      pen.beginPath();
      for (const [, x, y] of points) pen.lineTo(...place.to(x, y));
      pen.stroke();
    };
    Object.entries(this.run.tracks).forEach(([name, track], number) => {
      const colour = palette[number % palette.length];
      const now = this.at(track);
      pen.globalAlpha = 0.3;
      line(track, colour, 1.5);
      pen.globalAlpha = 1;
      line(track.slice(0, now + 1), colour, 2.5);
      const [, x, y, yaw] = track[now];
      const [right, down] = place.to(x, y);
      pen.save();
      pen.translate(right, down);
      pen.rotate(-yaw);
      pen.beginPath();
      for (const [ahead, aside] of [[12, 0], [-9, 8], [-5, 0], [-9, -8]]) pen.lineTo(ahead * ratio, -aside * ratio);
      pen.closePath();
      pen.fillStyle = colour;
      pen.fill();
      pen.restore();
      pen.fillStyle = colours.text;
      pen.fillText(name, right + 12 * ratio, down - 10 * ratio);
    });
    const { metres: length, text } = jauspy.settings.scaleBar((50 * ratio) / place.scale);
    const [x, y] = [12 * ratio, this.map.height - 12 * ratio];
    pen.strokeStyle = pen.fillStyle = colours.text;
    pen.lineWidth = 1.5 * ratio;
    pen.beginPath();
    for (const [right, up] of [[0, 5], [0, 0], [length * place.scale, 0], [length * place.scale, 5]]) pen.lineTo(x + right, y - up * ratio);
    pen.stroke();
    pen.fillText(text, x + 4 * ratio, y - 7 * ratio);
  }
  seekOnMap(event) {
    const place = this.place();
    if (!place) return;
    const ratio = this.map.width / this.map.clientWidth;
    let [near, best] = [Infinity, null];
    for (const [time, x, y] of Object.values(this.run.tracks).flat()) {
      const [right, down] = place.to(x, y);
      const far = Math.hypot(right - event.offsetX * ratio, down - event.offsetY * ratio);
      if (far < near) [near, best] = [far, time];
    }
    if (near < 30 * ratio) this.seek(best);
  }

  // --- values ------------------------------------------------------------------------------------------------------
  choose(index) {
    if (!Number.isInteger(index) || this.chosen.includes(index)) return;
    this.chosen.push(index);
    if (this.chosen.length > 6) this.chosen.shift();
    this.showChips();
  }
  showChips() {
    this.chips.replaceChildren(...this.chosen.map((index, place) => jauspy.make("span", { class: "trace", "data-place": place }, this.run.series[index].name,
      jauspy.make("button", { class: "remove", "aria-label": jauspy._("remove {name}", { name: this.run.series[index].name }), onclick: () => { this.chosen = this.chosen.filter((each) => each !== index); this.showChips(); } }, "×"))));
    this.drawPlot();
  }
  drawPlot() {
    this.fit(this.plot);
    const pen = this.plot.getContext("2d");
    const colours = jauspy.world.colours();
    const ratio = Math.min(2, devicePixelRatio);
    const { width, height } = this.plot;
    pen.clearRect(0, 0, width, height);
    const [left, right, top, bottom] = [46 * ratio, width - 10 * ratio, 8 * ratio, height - 18 * ratio];
    const series = this.chosen.map((index) => this.run.series[index]);
    const values = series.flatMap(({ points }) => points.map(([, value]) => value));
    let [low, high] = values.reduce(([least, most], value) => [Math.min(least, value), Math.max(most, value)], [Infinity, -Infinity]);
    if (!(high > low)) [low, high] = Number.isFinite(low) ? [low - 1, high + 1] : [0, 1];
    const x = (time) => left + ((right - left) * time) / Math.max(0.001, this.run.seconds);
    const y = (value) => bottom - ((bottom - top) * (value - low)) / (high - low);
    pen.strokeStyle = colours.line;
    pen.fillStyle = colours.quiet;
    pen.lineWidth = ratio;
    pen.font = `${10.5 * ratio}px system-ui, sans-serif`;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    for (const part of [0, 0.5, 1]) {
      const value = low + part * (high - low);
      pen.beginPath();
      pen.moveTo(left, y(value));
      pen.lineTo(right, y(value));
      pen.stroke();
      pen.fillText(String(Number(value.toPrecision(3))), left - 5 * ratio, y(value));
    }
    pen.textAlign = "center";
    const parts = right - left > 260 * ratio ? 4 : 2;
    for (let part = 0; part <= parts; part += 1) {
      const time = (part / parts) * this.run.seconds;
      pen.fillText(this.shown(time), Math.min(right - 14 * ratio, Math.max(left + 10 * ratio, x(time))), height - 8 * ratio);
    }
    const palette = jauspy.colours[colours.dark ? "dark" : "light"];
    series.forEach(({ points }, place) => {
      pen.strokeStyle = palette[place % palette.length];
      pen.lineWidth = 1.6 * ratio;
      pen.beginPath();
      for (const [time, value] of points) pen.lineTo(x(time), y(value));
      pen.stroke();
    });
    pen.strokeStyle = colours.accent;
    pen.lineWidth = 1.5 * ratio;
    pen.beginPath();
    pen.moveTo(x(this.time), top);
    pen.lineTo(x(this.time), bottom);
    pen.stroke();
  }
};

// One camera of a run: pictures are fetched in parts, and decoded when their time has come.
jauspy.RecordedCamera = class {
  PART = 4; // seconds that are fetched at once

  constructor(run, { topic, times, keys }) {
    Object.assign(this, { run, topic, times, keys, next: -1, loaded: new Map(), loading: new Set(), target: 0 });
    this.canvas = jauspy.make("canvas", { width: 320, height: 240, role: "img", "aria-label": jauspy._("video of {topic}", { topic }), "data-topic": topic });
    this.note = jauspy.make("div", { class: "run-name" }, topic);
    this.figure = jauspy.make("div", { class: "run-camera" }, this.canvas, this.note);
    if (!("VideoDecoder" in window)) this.fail(jauspy.video.missingDecoder());
  }
  close() {
    this.closed = true;
    if (this.decoder && this.decoder.state !== "closed") this.decoder.close();
  }
  fail(text) {
    this.failed = true;
    this.note.textContent = `${this.topic}: ${text}`;
  }
  // The number of the last picture up to a time; -1 if there is none.
  last(time) {
    let [low, high] = [-1, this.times.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= time + 1e-4) low = middle; else high = middle - 1;
    }
    return low;
  }
  show(time) {
    if (this.closed || this.failed) return;
    const last = this.last(time);
    if (last < 0) return;
    let key = last;
    while (key > 0 && !this.keys[key]) key -= 1;
    if (!this.keys[key]) return;
    if (last < this.next - 1 || key >= this.next || this.decoder?.state !== "configured") this.next = key; // a jump
    this.target = this.times[last];
    for (let part = Math.floor(this.times[this.next < this.times.length ? this.next : last] / this.PART); part <= Math.floor((time + this.PART) / this.PART); part += 1) this.load(part);
    while (this.next <= last) {
      const data = this.loaded.get(Math.floor(this.times[this.next] / this.PART))?.get(this.next);
      if (data === undefined) return; // it is being fetched, or lost
      this.decode(this.next, data);
      this.next += 1;
    }
  }
  async load(part) {
    if (this.loaded.has(part) || this.loading.has(part) || part * this.PART > this.run.run.seconds) return;
    this.loading.add(part);
    const { recordings } = jauspy;
    try {
      const query = `?topic=${encodeURIComponent(this.topic)}&begin=${part * this.PART}&end=${(part + 1) * this.PART}`;
      const content = await (await recordings.fetched(recordings.url("pictures", this.run.name, query))).arrayBuffer();
      const [view, found] = [new DataView(content), new Map()];
      for (let at = 0; at + 16 <= content.byteLength;) {
        const size = view.getUint32(at, true);
        const number = this.last(view.getFloat64(at + 8, true) + 1e-3);
        found.set(number, new Uint8Array(content, at + 16, size));
        at += 16 + size;
      }
      this.loaded.set(part, found);
      while (this.loaded.size > 6) this.loaded.delete(this.loaded.keys().next().value);
    } catch (error) {
      this.fail(error.message);
    } finally {
      this.loading.delete(part);
    }
    if (!this.run.playing) this.show(this.run.time);
  }
  decode(number, data) {
    const isKey = Boolean(this.keys[number]);
    if (isKey) this.configure(data);
    if (this.decoder?.state !== "configured") return;
    this.decoder.decode(new EncodedVideoChunk({ type: isKey ? "key" : "delta", timestamp: Math.round(1e6 * this.times[number]), data }));
  }
  // The name of the coding is in the sequence parameter set (NAL unit 7): profile, constraints, level.
  configure(data) {
    let at = 0;
    while (at + 6 < data.length && !(data[at] === 0 && data[at + 1] === 0 && data[at + 2] === 1 && (data[at + 3] & 31) === 7)) at += 1;
    if (at + 6 >= data.length) return;
    const codec = `avc1.${[...data.slice(at + 4, at + 7)].map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
    if (this.codec === codec && this.decoder?.state === "configured") return;
    if (this.decoder && this.decoder.state !== "closed") this.decoder.close();
    this.codec = codec;
    this.decoder = new VideoDecoder({
      output: (frame) => {
        if (frame.timestamp >= Math.round(1e6 * this.target) - 200000) this.draw(frame); // others are only on the way to it
        frame.close();
      },
      error: (error) => this.fail(jauspy._("this browser cannot decode the video ({codec}): {error}", { codec, error: error.message })),
    });
    try {
      this.decoder.configure({ codec, optimizeForLatency: true });
    } catch (error) {
      this.fail(jauspy._("this browser does not know the coding {codec}: {error}", { codec, error: error.message }));
    }
  }
  draw(frame) {
    if (this.canvas.width !== frame.displayWidth || this.canvas.height !== frame.displayHeight) [this.canvas.width, this.canvas.height] = [frame.displayWidth, frame.displayHeight];
    this.canvas.getContext("2d").drawImage(frame, 0, 0);
    this.canvas.dataset.time = frame.timestamp / 1e6;
    this.canvas.dataset.pictures = Number(this.canvas.dataset.pictures ?? 0) + 1;
  }
};

setInterval(jauspy.recordings.watch, 500);
