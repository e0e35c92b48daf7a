// What was said: sentences, replies, questions with their answers, and the line to say more.

import { keep, make, seconds } from "./dom.js";

const MOST_SUGGESTIONS = 6;
const HEARING = { listening: "Listening ...", thinking: "Thinking ...", replying: "Listening ..." };
const MARKS = { DONE: "✓", FAILED: "✕", REFUSED: "–", NEEDS_INFORMATION: "?", SUPERSEDED: "■" };
const byId = (id) => document.getElementById(id);

export class Talk {
  constructor({ say, select, listen }) {
    this.say = say;
    this.select = select;
    this.said = [];
    this.place = 0;
    this.words = [];
    this.sentences = [];
    this.here = [];
    this.input = byId("text");
    byId("say").addEventListener("submit", (event) => {
      event.preventDefault();
      this.send(this.input.value);
    });
    this.input.addEventListener("input", () => this.suggest());
    this.input.addEventListener("keydown", (event) => this.recall(event));
    byId("listen").addEventListener("click", listen);
  }

  send(text) {
    if (!text.trim() || !this.say(text.trim())) return;
    this.said = [...this.said.filter((one) => one !== text.trim()), text.trim()].slice(-100);
    this.place = this.said.length;
    this.input.value = "";
    this.suggest();
  }

  // A sentence is put into the line, so that it can be changed; a second click says it.
  offer(text) {
    if (this.input.value === text) {
      this.send(text);
    } else {
      this.input.value = text;
      this.suggest();
    }
    this.input.focus();
  }

  recall(event) {
    const step = { ArrowUp: -1, ArrowDown: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    this.place = Math.max(0, Math.min(this.said.length, this.place + step));
    this.input.value = this.said[this.place] || "";
    this.suggest();
  }

  know(view) {
    this.words = view.words;
    this.sentences = view.abilities.flatMap((ability) => ability.examples);
    this.suggest();
  }

  knowHere(view) {
    this.here = view.sentences;
    this.suggest();
  }

  suggest() {
    const text = this.input.value;
    const low = text.toLowerCase();
    let found = [];
    if (!low.trim()) {
      found = this.here;
    } else {
      found = [...this.here, ...this.sentences].filter((one) => one.toLowerCase().startsWith(low) && one.length > text.length).slice(0, 3);
      const last = /[\p{L}'-]+$/u.exec(low);
      if (last) {
        const head = text.slice(0, text.length - last[0].length);
        found.push(...this.words.filter((word) => word.startsWith(last[0]) && word !== last[0]).slice(0, 8).map((word) => `${head}${word} `));
      }
    }
    found = [...new Set(found)].slice(0, MOST_SUGGESTIONS);
    keep(byId("suggestions"), found, () => found.map((one) =>
      make("button", { type: "button", onclick: () => { this.input.value = one; this.input.focus(); this.suggest(); } }, one.trim())));
  }

  // What the robot hears, and what it asks before it does that; by voice it is answered.
  hear(view) {
    byId("listen").hidden = !view.state;
    byId("listen").setAttribute("aria-pressed", String(view.state === "listening"));
    const doing = HEARING[view.state] || "";
    const heard = view.heard && view.state !== "listening" ? `Heard: "${view.heard}". ` : "";
    byId("heard").textContent = view.state ? `${heard}${view.question || doing}` : "";
  }

  draw(commands, selected) {
    const log = byId("log"), frame = byId("log-frame");
    const isAtEnd = frame.scrollHeight - frame.scrollTop - frame.clientHeight < 60;
    const rows = new Map([...log.children].map((row) => [row.dataset.id, row]));
    for (const view of commands) {
      const row = rows.get(view.id) || log.appendChild(make("li", { "data-id": view.id }));
      rows.delete(view.id);
      const shown = { text: view.text, reply: view.reply, is: view.id === selected, now: view.now, since: view.since };
      keep(row, shown, () => this.row(view, shown));
      row.classList.toggle("selected", shown.is);
    }
    for (const row of rows.values()) row.remove();
    if (isAtEnd) frame.scrollTop = frame.scrollHeight;
    const asked = commands.filter((view) => view.question).pop();
    keep(byId("answers"), asked ? [asked.id, asked.question] : null, () => asked && asked.question.answers.map((answer) =>
      make("button", { type: "button", onclick: () => this.send(answer) }, answer)));
  }

  row(view, shown) {
    const person = make("button", {
      type: "button", class: "person", "aria-pressed": String(shown.is), onclick: () => this.select(view.id),
    }, view.text);
    if (!view.reply) return [person, make("p", { class: "robot waiting" }, shown.now || "...", seconds(shown.since))];
    return [person, make("p", { class: `robot ${view.reply.outcome}` },
      make("span", { class: "mark", "aria-hidden": "true" }, MARKS[view.reply.outcome] || ""), view.reply.sentence,
      view.reply.help ? make("span", { class: "help" }, view.reply.help) : null)];
  }
}
