// The page begins: with its content as it was packed, in one of its layouts.

const numbers = (Kind, text) => new Kind(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);

// GLSL in whole texts, and tables as numbers.
function unpacked(content) {
  const whole = parts => parts.map(i => content.glsl[i]).join("");
  for (const {programs} of [content, ...content.breaks, ...content.plots].flatMap(({scene}) => scene || []))
    for (const name in programs) programs[name] = programs[name].map(whole);
  for (const twin of Object.values(content.twins)) twin.text = whole(twin.text);
  for (const file of content.tables.flatMap(({files}) => files))
    file.numbers = numbers(file.format === "RGBA8" ? Uint8Array : Float32Array, file.numbers);
  return content;
}

const {classList} = document.documentElement, able = $("picture").getContext("webgl2", HOW);
classList.toggle("scene-only", location.hash.includes("scene"));
classList.toggle("scene-bare", location.hash.includes("scene-bare"));
classList.toggle("still-only", !able);
if (able) window.halfway = new Page(unpacked(JSON.parse($("content").textContent)));
