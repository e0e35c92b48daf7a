// Makes elements. Text from the robot only ever becomes the text of a node; no markup is read.

export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "onclick") element.addEventListener("click", value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return element;
}

const TAGS = new Set(["path", "text", "rect", "circle"]);
const ATTRIBUTES = new Set(["class", "d", "x", "y", "r", "rx", "cx", "cy", "width", "height", "text-anchor"]);
const SVG = "http://www.w3.org/2000/svg";

export function picture(value, label) {
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${value.width} ${value.height}`);
  svg.setAttribute("width", value.width);
  svg.setAttribute("height", value.height);
  // It shrinks to its place, but not until it is illegible; then its place scrolls.
  svg.style.minWidth = `${Math.round(0.75 * value.width)}px`;
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", label);
  for (const shape of value.shapes) {
    if (!TAGS.has(shape.tag)) continue;
    const element = document.createElementNS(SVG, shape.tag);
    for (const [name, text] of shape.attributes) if (ATTRIBUTES.has(name)) element.setAttribute(name, text);
    element.textContent = shape.text;
    svg.append(element);
  }
  return svg;
}

// Replaces the content of an element when the value has changed, so that focus and open details survive.
export function keep(element, value, draw) {
  const key = JSON.stringify(value);
  if (element.shown === key) return false;
  element.shown = key;
  const open = new Set([...element.querySelectorAll("details[open]")].map((one) => one.dataset.key));
  element.replaceChildren(...[draw(value)].flat().filter((child) => child));
  for (const one of element.querySelectorAll("details")) if (open.has(one.dataset.key)) one.open = true;
  return true;
}

// How long something has been going on; `tick` keeps it true.
export const seconds = (since) => make("time", { class: "for", "data-since": String(since) });

export function tick() {
  for (const one of document.querySelectorAll("time.for")) {
    const passed = Math.floor((Date.now() - Number(one.dataset.since)) / 1000);
    const text = passed < 2 ? "" : passed < 120 ? ` (${passed} s)` : ` (${Math.floor(passed / 60)} min)`;
    if (one.textContent !== text) one.textContent = text;
  }
}

export const duration = (seconds) =>
  seconds < 1 ? `${Math.round(seconds * 1000)} ms` : `${seconds < 10 ? seconds.toFixed(1) : Math.round(seconds)} s`;
