// A page in a frame of a deck, which drops the frames of slides that are away and loads them anew when they come back:
// what was set is kept in the frame's name, the one thing that lasts, for the address at which it was set.

class Deck {
  constructor(step) {
    this.mine = `halfway ${step}${location.search}\n`;
    this.free = parent !== window && /^(halfway |$)/.test(window.name); // a name that somebody gave is left alone
  }

  // The state of a frame that comes back; else undefined.
  get kept() {
    return this.free && window.name.startsWith(this.mine) ? window.name.slice(this.mine.length) : undefined;
  }

  keep(state) { if (this.free) window.name = this.mine + state; }
}

// A clicker's keys belong to the deck, also while a scene has the keyboard: reveal.js and Quarto are told.
function clicking() {
  document.addEventListener("keydown", event => {
    const method = {PageDown: "next", PageUp: "prev"}[event.key];
    if (!method || parent === window || !location.hash.includes("scene")) return;
    event.preventDefault();
    parent.postMessage(JSON.stringify({method}), "*");
  });
}
