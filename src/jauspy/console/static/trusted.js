// Which code the page may compile at run time: the default policy of Trusted Types, loaded before all other scripts.
// NiceGUI evaluates what the server sends, and Vue compiles templates, so the Content-Security-Policy cannot forbid it.
"use strict";

if (window.trustedTypes?.createPolicy) {
  // What the panels give NiceGUI as literals: values of properties that begin with a colon, and handlers of events.
  const PROPERTIES = ["[0]"];
  const HANDLERS = ["(event, row) => emit(row.number)", "() => jauspy.pickFile('.trajectory')", "() => jauspy.pickFile('.sound')", "() => jauspy.pickFile('.mission')"];
  // A call of a function of the console or of a method of an element, with data as its arguments.
  const CALL = /^(?:jauspy(?:\.[A-Za-z]+)+|return runMethod|\(async\(\) => \{return runMethod)\(([^]*?)\)(?:\}\)\(\))?;?$/;

  const isCall = (code) => {
    const data = CALL.exec(code)?.[1];
    if (data === undefined) return false;
    try {
      return Array.isArray(JSON.parse(`[${data}]`));
    } catch {
      return false;
    }
  };
  const isFunction = (code) => {
    const body = /^\(?function anonymous\((\w*)\n\) \{\n([^]*)\n\}\)?$/.exec(code);
    if (!body) return false;
    const [, parameter, text] = body;
    if (parameter === "Vue") return text.startsWith("const _Vue = Vue\n"); // a compiled template of a component
    return PROPERTIES.some((value) => text === `return (${value})`);
  };

  trustedTypes.createPolicy("default", {
    createScript(code, type, sink) {
      if (sink === "Function" ? isFunction(code) : HANDLERS.includes(code) || isCall(code)) return code;
      console.error(`the console does not run this code (${sink}): ${code.slice(0, 200)}`);
      return null;
    },
    createHTML: (html) => html, // what it contains loads nothing from elsewhere and runs nothing: script-src
    createScriptURL: (url) => (new URL(url, location.href).origin === location.origin ? url : null),
  });
}
