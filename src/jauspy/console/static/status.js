// The line below the bar: the sound of alarms, and marks of what has happened in the last ten minutes.
"use strict";

jauspy.alarm = {
  loud: false,

  isOn() {
    try {
      return localStorage.getItem("jauspy-sound") !== "off";
    } catch {
      return true;
    }
  },
  toggleSound() {
    try {
      localStorage.setItem("jauspy-sound", jauspy.alarm.isOn() ? "off" : "on");
    } catch { /* this browser keeps nothing */ }
    jauspy.alarm.show();
    if (jauspy.alarm.isOn()) jauspy.alarm.beep(1);
  },
  show() {
    const button = document.getElementById("alarm-sound");
    if (!button) return;
    const text = jauspy.alarm.isOn() ? jauspy._("sound on") : jauspy._("sound off");
    if (button.textContent !== text) button.textContent = button.title = text;
  },
  // Loud alarms sound every two seconds until they are acknowledged; others once.
  set(loud, isNew) {
    jauspy.alarm.loud = loud;
    document.body.dataset.alarm = loud ? "loud" : "none";
    if (isNew) jauspy.alarm.beep(loud ? 3 : 1);
  },
  // Browsers let a page sound after its first click or key.
  beep(times) {
    if (!jauspy.alarm.isOn() || !navigator.userActivation?.hasBeenActive || !window.AudioContext) return;
    const context = (jauspy.alarm.context ??= new AudioContext());
    for (let each = 0; each < times; each += 1) {
      const [tone, volume] = [context.createOscillator(), context.createGain()];
      const begin = context.currentTime + 0.22 * each;
      tone.frequency.value = each % 2 ? 660 : 880;
      volume.gain.setValueAtTime(0.15, begin);
      volume.gain.exponentialRampToValueAtTime(0.001, begin + 0.2);
      tone.connect(volume).connect(context.destination);
      tone.start(begin);
      tone.stop(begin + 0.21);
    }
    document.body.dataset.beeps = times + Number(document.body.dataset.beeps ?? 0);
  },
};
jauspy.timeLine = {
  SPAN: 600_000, // ms
  MOST: 300, // marks
  marks: [],

  add(events) {
    const place = document.getElementById("time-line");
    if (!place) return;
    for (const { time, text, kind } of events) {
      const mark = Object.assign(document.createElement("i"), { title: text });
      mark.dataset.kind = kind;
      place.append(mark);
      jauspy.timeLine.marks.push({ time, mark });
    }
    while (jauspy.timeLine.marks.length > jauspy.timeLine.MOST) jauspy.timeLine.marks.shift().mark.remove();
    jauspy.timeLine.draw();
  },
  draw() {
    const { marks, SPAN } = jauspy.timeLine;
    while (marks.length && marks[0].time < Date.now() - SPAN) marks.shift().mark.remove();
    for (const { time, mark } of marks) mark.style.left = `${100 - (100 * Math.max(0, Date.now() - time)) / SPAN}%`;
  },
};
addEventListener("keydown", (event) => {
  if (jauspy.letter(event) === "q" && !event.repeat && jauspy.isForPage(event)) emitEvent("alarms_acknowledged");
});
setInterval(() => {
  jauspy.alarm.show();
  jauspy.timeLine.draw();
  if (jauspy.alarm.loud) jauspy.alarm.beep(2);
}, 2000);
setTimeout(jauspy.alarm.show, 300);
