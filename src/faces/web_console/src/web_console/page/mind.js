// How a command was understood: stages, parse, frames, plan, trace.

import { duration, keep, make, picture, seconds } from "./dom.js";

const STAGES = [
  ["command_server", "Hear"], ["stanford_parser_ros", "Parse"], ["semantic_framer", "Frames"],
  ["frame_registrar", "Servers"], ["arbitrator", "Choose"], ["executor", "Do"],
];
const STATES = { waiting: "", active: "now", done: "done", failed: "failed", stopped: "stopped" };
const WAYS = {
  SEQUENCE: "one after the other", PARALLEL: "at the same time", ANY_ORDER: "in any order", FALLBACK: "or else",
  IF: "if", UNTIL: "until", WHILE: "while", REPEAT: "again and again", WAIT: "wait", AT: "at a time",
  WHENEVER: "whenever", CONDITION: "watch", ALL: "all of", ANY: "any of",
};

export function drawMind(element, view, cancel) {
  if (!view) {
    keep(element, null, () => make("div", { class: "card empty" },
      make("p", {}, "Say something, or choose a sentence of what it can do."),
      make("p", { class: "quiet" }, "Here you will see what the robot is going to do, and how far it is.")));
    return;
  }
  let parts = element.parts;
  if (!parts || element.viewId !== view.id) {
    const card = (name, title) => make("section", { class: `card engineer ${name}`, "aria-label": title });
    parts = element.parts = {
      person: make("section", { class: "card head", "aria-label": "Command" }), head: card("stages", "Stages"), parse: card("parse", "Parse"), frames: card("frames", "Frames"),
      plan: card("plan", "Plan"), trace: card("trace", "Trace"),
    };
    element.viewId = view.id;
    element.shown = null;
    element.replaceChildren(...Object.values(parts));
  }
  const fill = (part, value, draw) => {
    parts[part].hidden = !value;
    if (value) keep(parts[part], value, draw);
  };
  fill("person", [view.text, view.tasks, view.did, view.now, view.since, view.reply, view.is_cancellable], () => person(view, cancel));
  fill("head", [view.stages.map(({ trace, ...rest }) => rest), view.reply], () => head(view));
  fill("parse", view.parse, () => [title("Parse", "dependencies of the words"),
    make("div", { class: "wide", tabindex: "0" }, picture(view.parse, view.parse_words))]);
  fill("frames", view.clauses.length ? view.clauses : null, () => [title("Frames", "what the words mean"), ...view.clauses.map(clause)]);
  fill("plan", view.plan, () => [title("Plan", "who carries it out"), node(view.plan, true)]);
  const traced = view.stages.filter((stage) => stage.trace.length);
  fill("trace", traced.length ? traced.map((stage) => [stage.name, stage.trace]) : null, () => [
    title("Trace", "what each rule did"), ...traced.map(trace)]);
}

const title = (text, more) => make("h3", {}, text, make("small", {}, more));

function person(view, cancel) {
  const marks = { done: "✓", active: "●", failed: "✕", stopped: "■" };
  const tried = view.did.filter((words, place) => view.did.indexOf(words) === place);
  return [
    make("p", { class: "sentence" }, make("span", {}, `“${view.text}”`),
      view.is_cancellable && !view.reply
        ? make("button", { type: "button", class: "cancel", onclick: () => cancel(view.id) }, "Cancel") : null),
    view.tasks.length > 1 ? make("ol", { class: "tasks", "aria-label": "Steps" }, ...view.tasks.map((task) =>
      make("li", { class: task.state, "data-state": task.state },
        make("span", { class: "bead", "aria-hidden": "true" }, marks[task.state] || ""),
        make("span", { class: "task" }, task.text, task.note ? make("small", {}, task.note) : null),
        make("span", { class: "hidden" }, `, ${SPOKEN[task.state] || task.state}`)))) : null,
    view.reply ? make("p", { class: `reply ${view.reply.outcome}` }, view.reply.sentence) : make("p", { class: "reply" }, view.now || "...", seconds(view.since)),
    view.reply ? make("p", { class: "quiet" }, make("a", { href: `#said=${encodeURIComponent(view.id)}` }, "Link to this")) : null,
    view.reply && view.reply.help ? make("p", { class: "quiet" }, view.reply.help) : null,
    tried.length > 1 ? make("details", { "data-key": "did", open: Boolean(view.reply && view.reply.outcome === "FAILED") },
      make("summary", {}, view.reply && view.reply.outcome === "FAILED" ? "What it tried" : "What it did"),
      make("ol", { class: "did" }, ...tried.slice(-12).map((words) => make("li", {}, words)))) : null,
  ];
}

const SPOKEN = { waiting: "may come", active: "runs", done: "done", failed: "failed", stopped: "stopped" };

function head(view) {
  const reached = new Map(view.stages.map((stage) => [stage.name, stage]));
  const names = STAGES.map(([name]) => name);
  const last = Math.max(-1, ...view.stages.map((stage) => names.indexOf(stage.name)));
  const ended = view.reply ? view.reply.stage : "";
  const items = STAGES.map(([name, label], index) => {
    const stage = reached.get(name);
    let state = "waiting";
    if (name === ended && view.reply.outcome !== "DONE") state = view.reply.outcome;
    else if (stage || index < last || (index === 0 && view.stages.length)) state = view.reply || index < last ? "done" : "active";
    const text = stage ? stage.sentence : "";
    return make("li", { class: state, title: text, "data-stage": name },
      make("span", { class: "bead", "aria-hidden": "true" }), make("b", {}, label),
      make("span", { class: "time" }, stage ? `+${duration(stage.after_s)}` : ""));
  });
  const newest = view.stages[view.stages.length - 1];
  return [
    title("Stages", "how far it came, and why"),
    // A stop takes no stage.
    view.stages.length || !view.reply ? make("ol", { class: "strip" }, ...items) : null,
    view.reply
      ? make("p", { class: `reply ${view.reply.outcome}` }, make("b", {}, view.reply.code), " ", view.reply.sentence)
      : make("p", { class: "reply" }, newest ? newest.sentence : "Heard."),
  ];
}

function clause(view) {
  const [best, ...others] = view.readings;
  return make("div", { class: "clause" },
    make("p", { class: "words" }, view.words),
    best ? reading(best) : make("p", { class: "quiet" }, "no reading"),
    others.length
      ? make("details", { "data-key": view.words }, make("summary", {}, `${others.length} more ${others.length === 1 ? "reading" : "readings"}`),
        ...others.map(reading)) : null);
}

function reading(view) {
  return make("div", { class: "reading" },
    make("p", { class: "evoked" }, make("b", { class: "frame" }, view.frame), ` evoked by “${view.verb}”`,
      make("span", { class: "source" }, view.source)),
    make("dl", {}, ...view.arguments.flatMap(argument)),
    view.left_over.length
      ? make("p", { class: "left" }, "left over: ", ...view.left_over.map((word) => make("span", { class: "chip bad" }, word))) : null);
}

const argument = (view) => [
  make("dt", {}, view.name),
  make("dd", {}, make("span", { class: "value" }, view.text), ...view.notes.map((note) =>
    make("span", { class: `chip ${note.kind.replace(/\W/g, "-")}` }, make("i", {}, note.kind), " ", note.text))),
];

function node(view, isRoot) {
  const marked = { class: `node ${view.state}`, "data-state": view.state };
  const way = WAYS[view.kind];
  const name = make("p", { class: "label" }, way ? make("span", { class: "way" }, way) : null, view.label,
    ...view.notes.map((note) => make("span", { class: "chip" }, note)), stateWord(view.state));
  return make(isRoot ? "div" : "li", marked, name,
    view.children.length ? make("ul", {}, ...view.children.map((child) => node(child, false))) : null,
    ...view.candidates.map((one, index) => candidate(one, index, view.candidates.length)),
    view.more ? make("p", { class: "quiet" }, `and ${view.more} more candidates`) : null);
}

function candidate(view, index, count) {
  return make("div", { class: `candidate ${view.state}` },
    count > 1 ? make("span", { class: "number", title: `candidate ${index + 1}` }, String(index + 1)) : null,
    make("ol", {}, ...view.steps.map((step) => make("li", { class: `box ${step.state}`, "data-frame": step.frame, "data-state": step.state },
      make("b", {}, step.frame), make("span", { class: "by" }, step.server),
      make("span", { class: "with" }, step.arguments.map((one) => `${one.name} ${one.text}`).join(" · ")),
      stateWord(step.state)))),
    view.left_over.length ? make("p", { class: "left" }, "left over: ", view.left_over.join(", ")) : null);
}

const stateWord = (state) => (STATES[state] ? make("span", { class: "is" }, STATES[state]) : null);

function trace(stage) {
  return make("details", { "data-key": stage.name }, make("summary", {}, stage.name, make("span", { class: "count" }, String(stage.trace.length))),
    make("div", { class: "wide", tabindex: "0" }, make("table", {}, make("tbody", {}, ...stage.trace.map((line) =>
      make("tr", {}, make("th", { scope: "row" }, line.rule), make("td", {}, line.about), make("td", {}, line.effect)))))));
}
