// The robot where it is: a home or a map, the way it came and the way it goes. Leaflet draws it, zooms and pans.

import { labelBoxes } from "./labels.js";

const MOST_TRAIL = 600;
const LEAST_SPAN_M = 4;
const ROBOT_M = 0.28;
const DOOR_M = 0.9;
// The important first: the robot and what it holds, persons, rooms; then furniture and things, as far as there is room.
const RANKS = { robot: 0, person: 1, goal: 2, room: 3, place: 3, furniture: 4, door: 6, device: 5, thing: 5 };

// What lies above what.
const LAYERS = { room: 0.5, furniture: 1, door: 2, place: 2.5, thing: 3, device: 3, goal: 4, person: 5 };

export class Ground {
  constructor(element, text, card) {
    this.element = element;
    this.text = text;
    this.card = card;
    this.pose = null;
    this.trail = [];
    this.view = { map: null, path: [], landmarks: [] };
    this.due = 0;
    this.asked = false;
    this.isTouched = false;
  }

  move(pose) {
    const before = this.pose;
    if (before && before.frame !== pose.frame) this.trail = [];
    this.pose = pose;
    const last = this.trail[this.trail.length - 1];
    if (!last || Math.hypot(last.x_m - pose.x_m, last.y_m - pose.y_m) > 0.03) this.trail = [...this.trail, pose].slice(-MOST_TRAIL);
    this.element.dataset.heading = String(Math.round(pose.heading_rad * 180 / Math.PI));
    this.element.dataset.x = String(pose.x_m);
    this.element.dataset.y = String(pose.y_m);
    this.tell();
    this.soon();
  }

  surround(view) {
    this.view = view;
    this.tell();
    if (this.pose || view.map || view.landmarks.length) this.soon();
  }

  // In words, for those who do not see it.
  tell() {
    if (!this.pose) return;
    const { x_m: x, y_m: y } = this.pose;
    const inside = (one) => Math.abs(x - one.x_m) <= one.width_m / 2 && Math.abs(y - one.y_m) <= one.depth_m / 2;
    const room = this.view.landmarks.find((one) => one.kind === "room" && inside(one));
    const held = this.view.landmarks.filter((one) => one.is_held).map((one) => one.name);
    const where = room ? `In the ${room.name}` : `${x.toFixed(2)} m, ${y.toFixed(2)} m, heading ${this.element.dataset.heading}°`;
    const words = held.length ? `${where}. Holds ${held.join(" and ")}.` : `${where}${room ? "." : ""}`;
    if (this.text.textContent !== words) this.text.textContent = words;
  }

  soon() {
    this.card.hidden = false;
    if (!this.map) this.begin();
    else if (!this.due) this.due = requestAnimationFrame(() => { this.due = 0; this.draw(); });
  }

  async begin() {
    if (this.asked) return;
    this.asked = true;
    try {
      this.L = await import("./leaflet.js");
    } catch {
      this.element.hidden = true;
      return;
    }
    const L = this.L;
    this.map = L.map(this.element, {
      crs: L.CRS.Simple, attributionControl: false, zoomSnap: 0.25, zoomDelta: 0.75, wheelPxPerZoomLevel: 90, minZoom: 2, maxZoom: 9,
      zoomAnimation: false, fadeAnimation: false, markerZoomAnimation: false,
    });
    // What it shows is told in words below it, and in what the robot knows.
    this.map.getPane("mapPane").setAttribute("aria-hidden", "true");
    this.map.setView([0, 0], 5);
    this.rooms = L.layerGroup().addTo(this.map);
    this.ways = L.layerGroup().addTo(this.map);
    this.marks = L.layerGroup().addTo(this.map);
    this.labels = this.element.appendChild(document.createElement("div"));
    this.labels.className = "labels";
    this.labels.setAttribute("aria-hidden", "true");
    this.map.on("dragstart", () => { this.isTouched = true; });
    this.element.addEventListener("wheel", () => { this.isTouched = true; }, { passive: true });
    this.element.addEventListener("touchstart", (event) => { if (event.touches.length > 1) this.isTouched = true; }, { passive: true });
    this.element.addEventListener("click", (event) => { if (event.target.closest(".leaflet-control-zoom")) this.isTouched = true; });
    this.element.addEventListener("keydown", () => { this.isTouched = true; });
    this.map.on("zoom move resize", () => this.label());
    new ResizeObserver(() => { this.map.invalidateSize({ pan: false }); if (!this.isTouched) this.shown = ""; this.soon(); }).observe(this.element);
    this.draw();
  }

  // What has to be visible: the rooms or the map, or else the robot with its way and the places.
  bounds() {
    const map = this.view.map;
    const rooms = this.view.landmarks.filter((one) => one.kind === "room");
    const points = [];
    if (map) points.push(...cornersOfMap(map));
    for (const one of rooms) points.push(...corners(one));
    if (!points.length) {
      const near = [...this.view.path, ...this.view.landmarks, ...(this.pose ? [this.pose] : []), ...this.trail];
      for (const one of near) points.push([one.y_m, one.x_m]);
      if (this.pose) {
        points.push([this.pose.y_m - LEAST_SPAN_M / 2, this.pose.x_m - LEAST_SPAN_M / 2], [this.pose.y_m + LEAST_SPAN_M / 2, this.pose.x_m + LEAST_SPAN_M / 2]);
      }
    }
    return points;
  }

  fit() {
    const points = this.bounds();
    if (this.isTouched || !points.length || !this.element.clientWidth) return;
    const bounds = this.L.latLngBounds(points);
    const key = bounds.toBBoxString().split(",").map((one) => Math.round(2 * one)).join();
    if (key === this.shown) return;
    this.shown = key;
    this.map.fitBounds(bounds, { padding: [14, 14], animate: false });
  }

  draw() {
    const { L, view } = this;
    if (!this.map || !this.element.clientWidth) return;
    this.fit();
    const still = JSON.stringify([view.map, view.landmarks]);
    if (still !== this.drawn) {
      this.drawn = still;
      this.rooms.clearLayers();
      this.marks.clearLayers();
      if (view.map) this.picture(view.map);
      for (const one of [...view.landmarks].sort((one, other) => (LAYERS[one.kind] || 3) - (LAYERS[other.kind] || 3))) this.mark(one);
    }
    this.ways.clearLayers();
    if (this.trail.length > 1) L.polyline(this.trail.map(at), { className: "trail", interactive: false }).addTo(this.ways);
    if (view.path.length > 1) L.polyline(view.path.map(at), { className: "way", interactive: false }).addTo(this.ways);
    if (this.pose) this.robot(this.pose);
    this.label();
  }

  picture(map) {
    const bounds = [[map.y_m, map.x_m], [map.y_m + map.height_m, map.x_m + map.width_m]];
    const overlay = this.L.imageOverlay(map.address, bounds, { className: "grid-picture", alt: "Map" });
    // Leaflet places it as if it were not turned; its origin is its lower left corner.
    const place = overlay._reset;
    overlay._reset = function reset() {
      place.call(this);
      this._image.style.transformOrigin = "0 100%";
      this._image.style.transform += ` rotate(${-map.heading_rad}rad)`;
    };
    overlay.addTo(this.rooms);
  }

  mark(one) {
    const { L } = this;
    const shape = { className: `mark ${one.kind} ${one.states.join(" ")}`, interactive: one.kind !== "room" };
    let layer = null;
    if (one.is_held) return;
    if (one.kind === "door") layer = L.polyline(leaf(one), shape).addTo(this.rooms);
    else if (one.width_m && one.depth_m) layer = L.polygon(corners(one), shape).addTo(this.rooms);
    else layer = L.circleMarker(at(one), { ...shape, radius: { person: 7, goal: 6, place: 4 }[one.kind] || 3.5 }).addTo(this.marks);
    if (one.kind !== "room") {
      const name = document.createElement("span");
      name.textContent = [one.name, ...one.states].join(", ").replace(/=/g, " ");
      layer.bindTooltip(name, { sticky: true });
    }
  }

  robot(pose) {
    const { L } = this;
    const turn = (forward, left) => [
      pose.y_m + forward * Math.sin(pose.heading_rad) + left * Math.cos(pose.heading_rad),
      pose.x_m + forward * Math.cos(pose.heading_rad) - left * Math.sin(pose.heading_rad),
    ];
    const size = ROBOT_M, sight = [];
    for (let angle = -0.45; angle <= 0.46; angle += 0.15) sight.push(turn(3.2 * size * Math.cos(angle), 3.2 * size * Math.sin(angle)));
    L.polygon([turn(0, 0), ...sight], { className: "sight", interactive: false }).addTo(this.ways);
    L.circle(at(pose), { radius: size, className: "robot-body", interactive: false }).addTo(this.ways);
    L.polygon([turn(0.75 * size, 0), turn(-0.4 * size, 0.5 * size), turn(-0.15 * size, 0), turn(-0.4 * size, -0.5 * size)],
      { className: "robot-nose", interactive: false }).addTo(this.ways);
  }

  // Labels stand where they overlap nothing; those for which there is no room come with zoom, or under the pointer.
  label() {
    if (!this.map || !this.labels) return;
    const held = this.view.landmarks.filter((one) => one.is_held).map((one) => one.name);
    const wanted = this.view.landmarks.filter((one) => !one.is_held && one.kind !== "door" && one.kind !== "goal").map((one) => ({
      text: one.name, kind: one.kind, rank: RANKS[one.kind] ?? 5, ...pixels(this.map.latLngToContainerPoint(at(one))),
      isMiddle: one.kind === "room", wide_px: one.width_m ? this.map.options.crs.scale(this.map.getZoom()) * one.width_m : 0,
    }));
    if (this.pose && held.length) {
      wanted.push({ text: `holds ${held.join(", ")}`, kind: "robot", rank: 0, ...pixels(this.map.latLngToContainerPoint(at(this.pose))), isMiddle: false, wide_px: 0 });
    }
    const size = this.map.getSize();
    const taken = [{ left: 0, top: 0, width: 50, height: 78 }];
    if (this.pose) {
      const { x, y } = this.map.latLngToContainerPoint(at(this.pose));
      const half = Math.max(6, ROBOT_M * this.map.options.crs.scale(this.map.getZoom()));
      taken.push({ left: x - half, top: y - half, width: 2 * half, height: 2 * half });
    }
    const boxes = labelBoxes(wanted, { taken, width: size.x, height: size.y, zoom_px: this.map.options.crs.scale(this.map.getZoom()) });
    this.labels.replaceChildren(...boxes.map((box) => {
      const label = document.createElement("span");
      label.className = `name of-${box.kind}`;
      label.textContent = box.text;
      label.style.transform = `translate(${box.left}px, ${box.top}px)`;
      return label;
    }));
  }
}

const at = (one) => [one.y_m, one.x_m];
const pixels = (point) => ({ x: point.x, y: point.y });

function cornersOfMap(map) {
  const cos = Math.cos(map.heading_rad), sin = Math.sin(map.heading_rad);
  return [[0, 0], [map.width_m, 0], [map.width_m, map.height_m], [0, map.height_m]].map(([along, across]) =>
    [map.y_m + along * sin + across * cos, map.x_m + along * cos - across * sin]);
}

function corners(one) {
  const cos = Math.cos(one.heading_rad), sin = Math.sin(one.heading_rad);
  return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([along, across]) => {
    const dx = along * one.width_m / 2, dy = across * one.depth_m / 2;
    return [one.y_m + dx * sin + dy * cos, one.x_m + dx * cos - dy * sin];
  });
}

// A closed door is a line in its wall; an open one stands out from it. What is not known is drawn as closed, paler.
function leaf(one) {
  const long = Math.max(one.width_m, one.depth_m) || DOOR_M;
  const along = one.heading_rad + (one.depth_m > one.width_m ? Math.PI / 2 : 0);
  const half = { x: long / 2 * Math.cos(along), y: long / 2 * Math.sin(along) };
  const hinge = [one.y_m - half.y, one.x_m - half.x];
  const swing = one.states.includes("open") ? along + 1.2 : along;
  return [hinge, [hinge[0] + long * Math.sin(swing), hinge[1] + long * Math.cos(swing)]];
}
