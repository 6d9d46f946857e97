"use strict";
// The index: a search over all steps, and the pages that are looked at, as frames over their stills.

const MOST = 4; // frames alive at once: each has up to two WebGL contexts
const PATIENCE = 500; // ms that a card is looked at first
const cards = [...document.querySelectorAll("article")];
const texts = JSON.parse(document.getElementById("texts").textContent);
const live = new Map(), waiting = new Map();

function open(card) {
  if (live.has(card)) return;
  while (live.size >= MOST) close(live.keys().next().value);
  const frame = document.createElement("iframe");
  frame.src = `${card.dataset.page}#scene-bare,dark`;
  frame.title = card.querySelector("h3").textContent;
  frame.setAttribute("sandbox", "allow-scripts");
  live.set(card, frame);
  card.querySelector(".view").append(frame);
}

function close(card) {
  clearTimeout(waiting.get(card));
  if (live.has(card)) live.get(card).remove();
  live.delete(card);
}

addEventListener("message", event => { // the still shows until the page has drawn
  const frame = [...live.values()].find(one => one.contentWindow === event.source);
  if (frame && event.data.halfway === "ready") frame.classList.add("ready");
});

const seen = new IntersectionObserver(entries => {
  for (const {target, isIntersecting, intersectionRatio} of entries) {
    clearTimeout(waiting.get(target));
    if (intersectionRatio > 0.9) waiting.set(target, setTimeout(() => open(target), PATIENCE));
    else if (!isIntersecting) close(target);
  }
}, {threshold: [0, 0.95]});
for (const card of cards) seen.observe(card);

document.getElementById("search").addEventListener("input", event => {
  const wanted = event.target.value.toLowerCase().match(/[\p{L}\p{N}]+/gu) || [];
  let hits = 0;
  for (const card of cards) {
    const text = texts[card.id.slice(5)];
    card.hidden = !wanted.every(word => text.includes(word));
    hits += !card.hidden;
  }
  for (const part of document.querySelectorAll("section"))
    part.hidden = ![...part.querySelectorAll("article")].some(card => !card.hidden);
  document.getElementById("hits").textContent = wanted.length ? `${hits} of ${cards.length} steps` : "";
});
