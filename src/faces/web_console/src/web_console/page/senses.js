// Camera images, and two numbers over time. Nothing is asked for until somebody looks.

import { keep, make } from "./dom.js";

const LIST_MS = 3000;
const SOON_MS = 700;
const IMAGE_MS = 300;
const NUMBER_MS = 500;
const KEEP_MS = 120000;
const SVG = "http://www.w3.org/2000/svg";
// As many digits as a person reads.
const short = (value) => String(Number(value.toPrecision(4)));

export class Senses {
  constructor(details, cameras, plots) {
    this.details = details;
    this.cameras = cameras;
    this.plots = plots;
    this.offered = { cameras: {}, numbers: {} };
    this.camera = "";
    this.chosen = ["", ""];
    this.points = [[], []];
    details.addEventListener("toggle", () => this.list());
    setInterval(() => this.measure(), NUMBER_MS);
  }

  // Somebody looks: it is open, and on the screen.
  isSeen() {
    return this.details.open && !document.hidden && this.details.checkVisibility();
  }

  async list() {
    clearTimeout(this.due);
    if (!this.details.open) return;
    const isEmpty = !Object.keys(this.offered.numbers).length;
    this.due = setTimeout(() => this.list(), isEmpty ? SOON_MS : LIST_MS);
    if (!this.isSeen()) return;
    try {
      this.offered = await (await fetch("sensors.json")).json();
    } catch {
      return;
    }
    const names = Object.entries(this.offered.cameras);
    if (!(this.camera in this.offered.cameras)) this.camera = names.length ? names[0][0] : "";
    keep(this.cameras, names, () => names.length
      ? [this.choice("Camera", this.offered.cameras, this.camera, (place) => { this.camera = place; }), this.image()]
      : make("p", { class: "quiet" }, "No camera shows anything."));
    keep(this.plots, [this.offered.numbers], () => [0, 1].map((which) => this.plot(which)));
  }

  choice(label, offered, chosen, choose) {
    const select = make("select", { "aria-label": label }, ...Object.entries(offered).map(([place, name]) =>
      make("option", { value: place, selected: place === chosen }, name)));
    select.addEventListener("change", () => choose(select.value));
    return select;
  }

  // The next picture is asked for when this one is there.
  image() {
    const image = make("img", { class: "camera", alt: "What the camera shows", hidden: true });
    const next = () => setTimeout(() => {
      if (!image.isConnected) return;
      if (!this.isSeen()) { next(); return; }
      image.src = `camera?of=${this.camera}&at=${Date.now()}`;
    }, IMAGE_MS);
    image.addEventListener("load", () => { image.hidden = false; next(); });
    image.addEventListener("error", () => { image.hidden = true; next(); });
    next();
    return image;
  }

  plot(which) {
    const none = { "": which ? "No second number" : "No number" };
    const svg = document.createElementNS(SVG, "svg");
    svg.setAttribute("viewBox", "0 0 100 100");
    svg.setAttribute("preserveAspectRatio", "none");
    svg.setAttribute("role", "img");
    svg.setAttribute("aria-label", "The last two minutes");
    svg.append(document.createElementNS(SVG, "path"));
    return make("div", { class: `plot ${which ? "other" : "one"}` },
      this.choice(which ? "Second number" : "First number", { ...none, ...this.offered.numbers }, this.chosen[which], (place) => {
        this.chosen[which] = place;
        this.points[which] = [];
      }), make("p", {}, ""), svg);
  }

  async measure() {
    const chosen = this.chosen.map((place, which) => [place, which]).filter(([place]) => place);
    if (!chosen.length || !this.isSeen() || this.isAsking) return;
    this.isAsking = true;
    try {
      const values = await (await fetch(`numbers.json?of=${chosen.map(([place]) => place).join()}`)).json();
      const now = Date.now();
      chosen.forEach(([place, which], at) => {
        if (place !== this.chosen[which] || values[at] === null) return;
        this.points[which] = [...this.points[which].filter(([then]) => now - then < KEEP_MS), [now, values[at]]];
      });
      this.drawPlots(now);
    } catch { /* the next one may come */ } finally {
      this.isAsking = false;
    }
  }

  drawPlots(now) {
    [...this.plots.querySelectorAll(".plot")].forEach((plot, which) => {
      const points = this.points[which], values = points.map(([, value]) => value);
      const least = Math.min(...values), most = Math.max(...values), span = most - least || 1;
      const place = ([then, value]) => `${100 - (100 * (now - then)) / KEEP_MS},${95 - (90 * (value - least)) / span}`;
      plot.querySelector("path").setAttribute("d", points.length > 1 ? `M${points.map(place).join("L")}` : "");
      plot.querySelector("p").textContent = points.length ? `${short(values[values.length - 1])} (${short(least)} to ${short(most)})` : "";
    });
  }
}
