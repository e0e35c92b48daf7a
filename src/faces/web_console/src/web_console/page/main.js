// The connection, and what belongs where.

import { drawMind } from "./mind.js";
import { tick } from "./dom.js";
import { Ground } from "./ground.js";
import { drawLearned } from "./learned.js";
import { Past } from "./past.js";
import { Senses } from "./senses.js";
import { drawAbilities, drawHealth, drawOrders, drawProblems, drawWorld } from "./side.js";
import { Microphone } from "./microphone.js";
import { Talk } from "./talk.js";

const MOST_COMMANDS = 50;
const KEEP_STOP_MS = 10000;
const FOLLOW_MS = 500;
const byId = (id) => document.getElementById(id);

const commands = new Map();
let selected = "";
let socket = null;
let wait = 200;
let pendingStop = null;
let isFollowed = false, due = 0;
let status = { sentence: "", active: [] };
let stop = { number: 0, state: "", sentence: "" };

const ground = new Ground(byId("ground"), byId("ground-text"), byId("ground-card"));
const talk = new Talk({ say: (text) => ask({ verb: "say", text }), select: choose, listen: () => ask({ verb: "listen" }) });

new Senses(byId("senses"), byId("cameras"), byId("plots"));
const past = new Past({
  judge: (id, verdict, meant) => ask({ verb: "judge", id, verdict, meant }),
  offer: (text) => { show("talk"); talk.offer(text); },
});

function send(message) {
  if (socket && socket.readyState === WebSocket.OPEN) {
    socket.send(message);
    return true;
  }
  return false;
}

function ask(request) {
  return send(JSON.stringify(request));
}

const microphone = new Microphone(send);

async function turnMicrophone() {
  try {
    await (microphone.isOn ? microphone.end() : microphone.begin());
  } catch (error) {
    await microphone.end();
    say(`The microphone of this computer cannot be used: ${error.message}`, "bad");
  }
  byId("microphone").setAttribute("aria-pressed", String(microphone.isOn));
}

function choose(id) {
  selected = id;
  redraw();
}

function redraw() {
  const ordered = [...commands.values()].sort((one, other) => one.stamp_s - other.stamp_s);
  for (const old of ordered.splice(0, Math.max(0, ordered.length - MOST_COMMANDS))) commands.delete(old.id);
  talk.draw(ordered, selected);
  drawMind(byId("mind"), commands.get(selected), (id) => ask({ verb: "cancel", id }));
}

let frame = 0;
function redrawSoon() {
  // A hidden page draws nothing until it is seen again.
  if (!frame) frame = requestAnimationFrame(() => { frame = 0; redraw(); });
}

function showState() {
  const element = byId("state");
  const isOpen = socket && socket.readyState === WebSocket.OPEN;
  element.dataset.state = !isOpen ? "lost" : status.active.length ? "busy" : "ready";
  const doing = status.active.map((id) => commands.get(id)).filter((view) => view && view.now).map((view) => view.now).pop();
  byId("state-text").textContent = !isOpen ? "No connection" : status.active.length ? doing || "Working ..." : "Ready";
  byId("send").disabled = !isOpen;
}

function say(text, kind) {
  byId("banner").textContent = text;
  byId("note").dataset.kind = kind;
  byId("note").hidden = !text;
}

function showStop(view) {
  const isNew = view.number !== stop.number || view.state !== stop.state || view.sentence !== stop.sentence;
  stop = view;
  if (isNew && view.number) say(view.sentence, view.state === "stopped" ? "good" : view.state === "sent" ? "plain" : "bad");
}

const views = {
  command(view) {
    const isNew = !commands.has(view.id);
    const before = commands.get(view.id);
    commands.set(view.id, { ...view, since: before && before.now === view.now ? before.since : Date.now() });
    const newest = [...commands.values()].reduce((one, other) => (other.stamp_s >= one.stamp_s ? other : one));
    if (!selected || (isNew && newest.id === view.id)) selected = view.id;
    redrawSoon();
    showState();
  },
  status(view) { status = view; showState(); },
  abilities(view) { drawAbilities(view, (text) => talk.offer(text)); talk.know(view); },
  suggestions: (view) => talk.knowHere(view),
  problems: drawProblems,
  health: drawHealth,
  world: drawWorld,
  orders: drawOrders,
  learned: (view) => drawLearned(view, (text) => ask({ verb: "say", text })),
  pose: (view) => ground.move(view),
  ground: (view) => ground.surround(view),
  past: () => past.changed(),
  stop: showStop,
  emergency: showEmergency,
  notice: (view) => say(view.text, "bad"),
  voice(view) { talk.hear(view); byId("microphone").hidden = !(view.takes_sound && microphone.isThere); },
  unheard(view) { if (view) say(`Nobody heard "${view}": command_server is not there. Is the pipeline up?`, "bad"); },
};

function connect() {
  const address = new URL("live", location.href);
  address.protocol = address.protocol === "https:" ? "wss:" : "ws:";
  address.search = address.hash = "";
  socket = new WebSocket(address);
  socket.addEventListener("open", () => {
    wait = 200;
    // What was open when the connection was lost is told anew, or has been lost with the server.
    for (const [id, view] of commands) if (!view.reply) commands.delete(id);
    say("", "plain");
    if (pendingStop && Date.now() - pendingStop.since < KEEP_STOP_MS) ask({ verb: pendingStop.verb });
    pendingStop = null;
    showState();
    // What the node still has comes first.
    if (!isFollowed) due = setTimeout(follow, FOLLOW_MS);
    isFollowed = true;
  });
  socket.addEventListener("message", (event) => {
    const message = JSON.parse(event.data);
    if (Object.hasOwn(views, message.view)) views[message.view](message.value);
  });
  socket.addEventListener("close", () => {
    showState();
    say("No connection to the robot. Trying again ... Until then this page cannot stop it.", "bad");
    setTimeout(connect, wait);
    wait = Math.min(2000, wait * 1.6);
  });
}

function stopRobot(verb = "stop") {
  if (ask({ verb })) return;
  pendingStop = { verb, since: Date.now() };
  say("Not sent: there is no connection. Use the emergency stop of the robot.", "bad");
}

function showEmergency(view) {
  byId("held").hidden = !view.is_engaged;
  byId("held-text").textContent = view.sentence;
}

byId("microphone").addEventListener("click", turnMicrophone);
byId("stop").addEventListener("click", () => stopRobot());
byId("emergency").addEventListener("click", () => stopRobot("emergency_stop"));
byId("release").addEventListener("click", () => {
  if (confirm("The robot may move again. Is everybody clear of it?")) ask({ verb: "say", text: "Release the emergency stop." });
});
document.addEventListener("keydown", (event) => {
  if (event.key === "Escape") stopRobot();
  else if (event.key === "/" && !/^(INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) {
    event.preventDefault();
    byId("text").focus();
  }
});
byId("dismiss").addEventListener("click", () => say("", "plain"));

// One switch shows servers, frames and patterns, and it is kept.
function showEngineer(isOn) {
  document.body.classList.toggle("for-engineers", isOn);
  byId("engineer").setAttribute("aria-pressed", String(isOn));
}
const kept = { get: () => { try { return localStorage.getItem("engineer"); } catch { return null; } },
  set: (value) => { try { localStorage.setItem("engineer", value); } catch { /* a browser that keeps nothing */ } } };
byId("engineer").addEventListener("click", () => {
  const isOn = !document.body.classList.contains("for-engineers");
  kept.set(isOn ? "on" : "off");
  showEngineer(isOn);
});
showEngineer(kept.get() === "on");

byId("large").addEventListener("click", () => {
  const isOn = document.body.classList.toggle("large-map");
  byId("large").setAttribute("aria-pressed", String(isOn));
});

// On a telephone one part is on the screen at a time.
function show(part) {
  document.body.dataset.part = part;
  for (const tab of document.querySelectorAll(".tabs button")) {
    if (tab.dataset.part === part) tab.setAttribute("aria-current", "true"); else tab.removeAttribute("aria-current");
  }
}
for (const tab of document.querySelectorAll(".tabs button")) tab.addEventListener("click", () => {
  // Who chooses a part wants to see that one, and not the one of the link.
  isFollowed = true;
  clearTimeout(due);
  show(tab.dataset.part);
});

// A link to a moment: the command is chosen, or found among what was said before.
function follow() {
  const id = new URLSearchParams(location.hash.slice(1)).get("said");
  if (!id) return;
  if (commands.has(id)) {
    show("plan");
    choose(id);
    return;
  }
  show("more");
  past.find(id);
}
addEventListener("hashchange", follow);
setInterval(() => { if (!document.hidden) tick(); }, 1000);

redraw();
connect();
showState();
