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
  document.addEventListener("keydown", ({key}) => {
    if (key !== "Escape") return;
    document.activeElement.blur();
    post({halfway: "escape"});
    parent.focus(); // a deck gets its keys back
  });
}
