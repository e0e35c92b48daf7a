// What the robot can do, problems in files, and the nodes.

import { keep, make } from "./dom.js";

const byId = (id) => document.getElementById(id);
let abilities = { abilities: [] };
let offer = () => {};

export function drawAbilities(view, onChoose) {
  abilities = view;
  offer = onChoose;
  draw();
}

function draw() {
  const wanted = byId("filter").value.trim().toLowerCase();
  const found = abilities.abilities.filter((one) =>
    [one.frame, one.description, one.domain, ...one.examples].join(" ").toLowerCase().includes(wanted));
  keep(byId("abilities"), [found, abilities.frames], () => {
    if (!found.length) return make("p", { class: "quiet" }, abilities.frames ? "Nothing, so far." : "Waiting for the robot ...");
    const domains = new Map();
    for (const one of found) domains.set(one.domain, [...(domains.get(one.domain) || []), one]);
    return [...domains].map(([domain, ones]) => make("div", { class: "domain" }, make("h3", {}, domain), ...ones.map(ability)));
  });
}

function ability(view) {
  return make("details", { "data-key": view.frame },
    make("summary", { title: view.description }, make("b", { class: "frame engineer" }, view.frame), make("span", { class: "first" }, view.examples[0])),
    make("p", { class: "quiet engineer" }, view.description, view.servers.length ? ` By ${view.servers.join(", ")}.` : ""),
    make("div", { class: "examples" }, ...view.examples.map((text) => make("button", { type: "button", onclick: () => offer(text) }, text))));
}

export function drawProblems(view) {
  byId("problems-card").hidden = !view.problems.length;
  keep(byId("problems"), view.problems, () => view.problems.map((one) => make("div", { class: "problem" },
    make("code", {}, one.place), make("p", {}, `found ${one.found}, expected ${one.expected}. ${one.hint}`))));
}

export function drawWorld(view) {
  byId("world-card").hidden = !view.objects.length;
  keep(byId("world"), view, () => [
    make("ul", { class: "nodes" }, ...view.objects.map((one) => make("li", {}, make("b", {}, one.name),
      make("span", { class: "quiet" }, [one.sort, one.where, ...one.attributes].filter((part) => part).join(", "))))),
    view.more ? make("p", { class: "quiet" }, `and ${view.more} more`) : null,
  ]);
}

export function drawOrders(view) {
  byId("orders-card").hidden = !view.orders.length;
  const about = (one) => [one.state === "waits" ? "" : one.state, one.reason, one.next_s ? `next ${new Date(1000 * one.next_s).toLocaleString()}` : "",
    one.count ? `done ${one.count} times` : ""].filter((part) => part).join(", ");
  keep(byId("orders"), view, () => make("ul", { class: "nodes" }, ...view.orders.map((one) => make("li", { "data-state": one.state },
    make("b", {}, one.sentence), make("span", { class: "quiet" }, about(one))))));
}

export function drawHealth(view) {
  keep(byId("health"), view, () => {
    if (!view.is_master_up) return make("p", { class: "bad" }, "The ROS master does not answer: the robot's programs cannot find each other.");
    const bad = view.nodes.filter((one) => one.state !== "runs");
    const list = (nodes) => make("ul", { class: "nodes" }, ...nodes.map((one) => make("li", { "data-state": one.state, "data-node": one.name },
      make("span", { class: "dot", "aria-hidden": "true" }), make("b", {}, one.name), make("span", { class: "quiet" }, one.state === "runs" ? one.role : one.state))));
    if (!view.nodes.length) return make("p", { class: "quiet" }, "Asking ...");
    return [
      bad.length ? [make("p", { class: "bad" }, `${bad.length} of ${view.nodes.length} programs of the robot do not run.`), make("div", { class: "engineer" }, list(bad))]
        : make("p", { class: "good" }, `All ${view.nodes.length} run.`),
      make("details", { "data-key": "nodes", class: "engineer" }, make("summary", {}, "All nodes"), list(view.nodes)),
    ].flat();
  });
}

byId("filter").addEventListener("input", draw);
