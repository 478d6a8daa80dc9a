// English and Chinese: elements carry the Chinese text beside the English, and the page swaps them.
export let language = "en";
const listeners = [];

// Chinese of the script's own words, from the catalogue `script.po`.
const catalogue = JSON.parse(document.getElementById("words").textContent);

/** A text in both languages; `{name}` in it stands for a value, or for a text in both languages. */
export const both = (text, values = {}) =>
  [text, catalogue[text] ?? text].map((said, i) =>
    said.replace(/\{(\w+)\}/g, (_, name) => (Array.isArray(values[name]) ? values[name][i] : values[name])),
  );

export const pick = (pair) => (language === "zh" ? pair[1] : pair[0]);

/** Calls a function now and after each change of the language. */
export function translated(fill) {
  listeners.push(fill);
  fill();
}

/** An element with a text in both languages. */
export function element(name, { text, label, ...attributes } = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === false || value === undefined) continue;
    made.setAttribute(key, value === true ? "" : value);
  }
  if (text) {
    made.textContent = text[0];
    made.dataset.zh = text[1];
  }
  if (label) {
    made.setAttribute("aria-label", label[0]);
    made.dataset.labelZh = label[1];
  }
  made.append(...children);
  if (language === "zh") swap(made, "zh");
  return made;
}

/** Puts a text in both languages into an element; none empties it. */
export function say(node, [en, zh] = ["", ""]) {
  Object.assign(node.dataset, { en, zh });
  swapOne(node, language);
}

function swapOne(node, to) {
  const { dataset } = node;
  if (dataset.zh !== undefined) {
    dataset.en ??= node.textContent;
    node.textContent = to === "zh" ? dataset.zh : dataset.en;
  }
  if (dataset.labelZh !== undefined) {
    dataset.labelEn ??= node.getAttribute("aria-label");
    const label = to === "zh" ? dataset.labelZh : dataset.labelEn;
    node.setAttribute("aria-label", label);
    if (node.title || node.tagName === "BUTTON") node.title = label;
  }
}

function swap(root, to) {
  if (root.dataset) swapOne(root, to);
  for (const node of root.querySelectorAll("[data-zh], [data-label-zh]")) swapOne(node, to);
}

/** Shows the page in a language. */
export function speak(to) {
  language = to;
  document.documentElement.lang = to === "zh" ? "zh-CN" : "en";
  swap(document.body, to);
  for (const fill of listeners) fill();
}

/** Reads or writes a choice that outlives the page, where the browser allows it. */
export function remembered(key, value) {
  try {
    if (value === undefined) return localStorage.getItem(`cadgen-${key}`);
    localStorage.setItem(`cadgen-${key}`, value);
  } catch {
    // A file from a disk may have no storage; then the choice holds for this visit.
  }
  return value ?? null;
}

/** Puts HTML of this program into an element, in the language that the page has. */
export function fill(node, html) {
  node.innerHTML = html;
  if (language === "zh") swap(node, "zh");
}
