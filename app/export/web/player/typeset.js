
// The formulas of a page, once its picture stands; at once where there will be none.
function typeset() {
  for (const one of document.querySelectorAll(".tex"))
    katex.render(one.textContent, one, {displayMode: one.dataset.display === "yes", throwOnError: false, strict: false,
                                        trust: ({command}) => command === "\\htmlClass"});
}

if (!window.halfway) typeset();
