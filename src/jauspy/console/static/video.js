// Video: encoded pictures by WebSocket, decoded by WebCodecs, drawn on a canvas.
"use strict";

jauspy.watch = (canvas, component) => {
  if (canvas.jauspySocket) return;
  const context = canvas.getContext("2d");
  const note = canvas.parentElement.querySelector(".video-note");
  const tell = (text) => { if (note) note.textContent = text; };
  if (!("VideoDecoder" in window)) { tell("this browser has no WebCodecs"); return; }
  let decoder = null;
  let shown = 0;
  const socket = new WebSocket(jauspy.url(`video/${component}`));
  socket.binaryType = "arraybuffer";
  canvas.jauspySocket = socket;
  tell("waiting for the camera …");
  const open = (codec) => {
    if (decoder && decoder.state !== "closed") decoder.close();
    decoder = new VideoDecoder({
      output(frame) {
        if (canvas.width !== frame.displayWidth || canvas.height !== frame.displayHeight) {
          canvas.width = frame.displayWidth;
          canvas.height = frame.displayHeight;
        }
        context.drawImage(frame, 0, 0);
        frame.close();
        shown += 1;
        canvas.dataset.pictures = shown;
        tell("");
      },
      error(problem) { tell(`the video cannot be decoded: ${problem.message}`); },
    });
    decoder.configure({ codec, optimizeForLatency: true });
  };
  socket.onmessage = (event) => {
    if (typeof event.data === "string") { open(event.data); return; }
    if (!decoder || decoder.state !== "configured") return;
    const header = new DataView(event.data, 0, 16);
    decoder.decode(new EncodedVideoChunk({
      type: header.getUint8(0) ? "key" : "delta",
      timestamp: header.getFloat64(8, true),
      data: new Uint8Array(event.data, 16),
    }));
  };
  socket.onclose = () => {
    canvas.jauspySocket = null;
    if (decoder && decoder.state !== "closed") decoder.close();
    if (canvas.isConnected) { tell("no connection"); setTimeout(() => jauspy.watch(canvas, component), 1000); }
  };
};

jauspy.enlarge = (figure) => {
  for (const each of figure.parentElement.children) each.classList.toggle("large", each === figure);
};

jauspy.watchAll = () => {
  for (const canvas of document.querySelectorAll("canvas[data-component]")) jauspy.watch(canvas, canvas.dataset.component);
};

setInterval(jauspy.watchAll, 500);
