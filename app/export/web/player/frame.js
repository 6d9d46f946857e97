// A page in a frame is spoken to with postMessage, and answers the window that asked:
//   {halfway: "set", state: "tilt=30&view=-50,22,6"}  sets what is named, as a link in the prose does
//   {halfway: "get"}        -> {halfway: "state", step, state, values, numbers}
//   {halfway: "snapshot"}   -> {halfway: "snapshot", step, state, png: "data:image/png;base64,..."}
// Unasked it tells its parent {halfway: "ready"} once it is drawn, {halfway: "state", ...} after a change, and
// {halfway: "escape"}.

const post = message => parent === window || parent.postMessage(message, "*");

function conversing(page) {
  addEventListener("message", ({data, source}) => {
    if (data?.halfway === "set") page.set(String(data.state || "").replace(/^.*\?/, ""));
    if (data?.halfway === "get") source.postMessage(page.report(), "*");
    if (data?.halfway === "snapshot") source.postMessage(page.snapshot(), "*");
  });
  document.addEventListener("click", event => {
    const link = event.target.closest("a[href^='?']");
    if (!link) return;
    event.preventDefault();
    page.set(link.getAttribute("href").slice(1));
  });
  document.addEventListener("keydown", event => {
    const method = {PageDown: "next", PageUp: "prev"}[event.key];
    if (event.key === "Escape") {
      document.activeElement.blur();
      post({halfway: "escape"});
      parent.focus(); // a deck gets its keys back
    } else if (method && parent !== window && location.hash.includes("scene")) {
      event.preventDefault();
      post(JSON.stringify({method})); // a clicker's keys belong to the deck: reveal.js and Quarto are told
    }
  });
}

// A deck drops the frames of slides that are away and loads them anew when they come back: what was set is kept in the
// frame's name, the one thing that lasts, for the address at which it was set.
class Kept {
  constructor(step) {
    this.mine = `halfway ${step}${location.search}\n`;
    this.free = parent !== window && /^(halfway |$)/.test(window.name); // a name that somebody gave is left alone
  }

  // The state of a frame that comes back; else undefined.
  get state() {
    return this.free && window.name.startsWith(this.mine) ? window.name.slice(this.mine.length) : undefined;
  }

  set state(text) { if (this.free) window.name = this.mine + text; }
}
