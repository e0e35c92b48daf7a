// The robot on its ground: map, path, places, the way it came.

const MOST_TRAIL = 600;
const GLIDE_MS = 120;
const LEAST_SPAN_M = 4;
const still = matchMedia("(prefers-reduced-motion: reduce)");
const wrap = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

export class Ground {
  constructor(canvas, text, card) {
    this.canvas = canvas;
    this.text = text;
    this.card = card;
    this.pose = this.from = null;
    this.trail = [];
    this.view = { map: null, path: [], landmarks: [] };
    this.image = null;
    this.due = 0;
    new ResizeObserver(() => this.soon()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.tint());
  }

  move(pose) {
    const before = this.pose;
    if (before && before.frame !== pose.frame) this.trail = [];
    this.from = before && !still.matches ? this.at() : pose;
    this.since = performance.now();
    this.pose = pose;
    const last = this.trail[this.trail.length - 1];
    if (!last || Math.hypot(last.x_m - pose.x_m, last.y_m - pose.y_m) > 0.03) this.trail = [...this.trail, pose].slice(-MOST_TRAIL);
    const degrees = Math.round(pose.heading_rad * 180 / Math.PI);
    const words = `${pose.x_m.toFixed(2)} m, ${pose.y_m.toFixed(2)} m, heading ${degrees}°`;
    this.text.textContent = words;
    this.canvas.setAttribute("aria-label", `The robot is at ${words}`);
    this.canvas.dataset.heading = String(degrees);
    this.canvas.dataset.x = String(pose.x_m);
    this.canvas.dataset.y = String(pose.y_m);
    this.card.hidden = false;
    this.soon();
  }

  surround(view) {
    const old = this.view.map;
    this.view = view;
    if (view.map || view.landmarks.length) this.card.hidden = false;
    if (view.map && (!old || old.address !== view.map.address)) {
      const image = new Image();
      image.addEventListener("load", () => { this.raw = image; this.tint(); });
      image.src = view.map.address;
    }
    this.soon();
  }

  // The picture holds only how opaque each place is; the colour is the theme's.
  tint() {
    if (this.raw) {
      const copy = document.createElement("canvas");
      copy.width = this.raw.width;
      copy.height = this.raw.height;
      const pen = copy.getContext("2d");
      pen.drawImage(this.raw, 0, 0);
      pen.globalCompositeOperation = "source-in";
      pen.fillStyle = this.colour("--wall");
      pen.fillRect(0, 0, copy.width, copy.height);
      this.image = copy;
    }
    this.soon();
  }

  colour(name) { return getComputedStyle(this.canvas).getPropertyValue(name).trim(); }

  soon() {
    if (!this.due) this.due = requestAnimationFrame(() => { this.due = 0; this.draw(); });
  }

  at() {
    const part = Math.min(1, (performance.now() - this.since) / GLIDE_MS);
    if (part >= 1 || !this.from) return this.pose;
    const turn = wrap(this.pose.heading_rad - this.from.heading_rad);
    return {
      ...this.pose,
      x_m: this.from.x_m + part * (this.pose.x_m - this.from.x_m),
      y_m: this.from.y_m + part * (this.pose.y_m - this.from.y_m),
      heading_rad: this.from.heading_rad + part * turn,
    };
  }

  // What has to be visible: the map, or else the robot with its way and the places.
  bounds(pose) {
    const map = this.view.map;
    if (map) return [map.x_m, map.y_m, map.x_m + map.width_m, map.y_m + map.height_m];
    const points = [...this.trail, ...this.view.path, ...this.view.landmarks, ...(pose ? [pose] : [])];
    const xs = points.map((point) => point.x_m), ys = points.map((point) => point.y_m);
    const middle = [(Math.min(...xs) + Math.max(...xs)) / 2 || 0, (Math.min(...ys) + Math.max(...ys)) / 2 || 0];
    const span = Math.max(LEAST_SPAN_M, 1.3 * (Math.max(...xs) - Math.min(...xs)) || 0, 1.3 * (Math.max(...ys) - Math.min(...ys)) || 0);
    return [middle[0] - span / 2, middle[1] - span / 2, middle[0] + span / 2, middle[1] + span / 2];
  }

  draw() {
    const { canvas } = this;
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = devicePixelRatio || 1;
    if (!width) return;
    if (canvas.width !== Math.round(width * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const pose = this.pose && this.at();
    const [left, bottom, right, top] = this.bounds(pose);
    const scale = Math.min((width - 24) / (right - left), (height - 24) / (top - bottom));
    const x = (value) => width / 2 + (value - (left + right) / 2) * scale;
    const y = (value) => height / 2 - (value - (bottom + top) / 2) * scale;
    const pen = canvas.getContext("2d");
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    this.grid(pen, x, y, width, height, scale);
    const map = this.view.map;
    if (map && this.image) {
      pen.save();
      pen.imageSmoothingEnabled = scale * map.width_m < this.image.width;
      pen.translate(x(map.x_m), y(map.y_m));
      pen.rotate(-map.heading_rad);
      pen.drawImage(this.image, 0, -map.height_m * scale, map.width_m * scale, map.height_m * scale);
      pen.restore();
    }
    this.line(pen, this.trail, x, y, "--trail", []);
    this.line(pen, this.view.path, x, y, "--accent", [6, 5]);
    if (pose) this.robot(pen, x(pose.x_m), y(pose.y_m), pose.heading_rad, Math.max(11, Math.min(22, 0.25 * scale)));
    pen.font = "12px system-ui, sans-serif";
    pen.textAlign = "center";
    for (const one of this.view.landmarks) {
      pen.fillStyle = this.colour(one.kind === "place" ? "--muted" : "--accent");
      pen.beginPath();
      pen.arc(x(one.x_m), y(one.y_m), one.kind === "place" ? 3 : 5, 0, 7);
      pen.fill();
      // The goal stands on the place that it is.
      if (one.kind === "goal") continue;
      pen.strokeStyle = this.colour("--card");
      pen.lineWidth = 3;
      pen.strokeText(one.name, x(one.x_m), y(one.y_m) - 8);
      pen.fillText(one.name, x(one.x_m), y(one.y_m) - 8);
    }
    if (this.pose && this.from !== this.pose && performance.now() - this.since < GLIDE_MS) this.soon();
  }

  grid(pen, x, y, width, height, scale) {
    const step = [0.25, 0.5, 1, 2, 5, 10, 50].find((one) => one * scale >= 28) || 100;
    pen.strokeStyle = this.colour("--line");
    pen.lineWidth = 1;
    pen.beginPath();
    const first = (at, low) => Math.ceil(low / step) * step;
    const west = (0 - x(0)) / scale, south = (y(0) - height) / scale;
    for (let at = first(0, west); x(at) < width; at += step) { pen.moveTo(Math.round(x(at)) + 0.5, 0); pen.lineTo(Math.round(x(at)) + 0.5, height); }
    for (let at = first(0, south); y(at) > 0; at += step) { pen.moveTo(0, Math.round(y(at)) + 0.5); pen.lineTo(width, Math.round(y(at)) + 0.5); }
    pen.stroke();
    pen.fillStyle = this.colour("--muted");
    pen.font = "11px system-ui, sans-serif";
    pen.textAlign = "left";
    pen.fillText(`${step} m`, 8, height - 8);
  }

  line(pen, points, x, y, colour, dash) {
    if (points.length < 2) return;
    pen.strokeStyle = this.colour(colour);
    pen.lineWidth = 3;
    pen.lineJoin = pen.lineCap = "round";
    pen.setLineDash(dash);
    pen.beginPath();
    points.forEach((point, index) => (index ? pen.lineTo(x(point.x_m), y(point.y_m)) : pen.moveTo(x(point.x_m), y(point.y_m))));
    pen.stroke();
    pen.setLineDash([]);
  }

  robot(pen, x, y, heading, radius) {
    pen.save();
    pen.translate(x, y);
    pen.rotate(-heading);
    pen.fillStyle = this.colour("--accent-soft");
    pen.beginPath();
    pen.moveTo(0, 0);
    pen.arc(0, 0, radius * 2.4, -0.45, 0.45);
    pen.fill();
    pen.fillStyle = this.colour("--accent");
    pen.strokeStyle = this.colour("--card");
    pen.lineWidth = 2;
    pen.beginPath();
    pen.arc(0, 0, radius, 0, 7);
    pen.fill();
    pen.stroke();
    pen.fillStyle = this.colour("--card");
    pen.beginPath();
    pen.moveTo(radius * 0.7, 0);
    pen.lineTo(-radius * 0.35, radius * 0.5);
    pen.lineTo(-radius * 0.1, 0);
    pen.lineTo(-radius * 0.35, -radius * 0.5);
    pen.fill();
    pen.restore();
  }
}
