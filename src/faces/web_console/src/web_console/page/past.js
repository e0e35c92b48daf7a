// What was said before: found, judged right or wrong, and kept as files. Nothing is asked for until somebody looks.

import { keep, make } from "./dom.js";

const WAIT_MS = 250;
const byId = (id) => document.getElementById(id);
const query = (words, before) => new URLSearchParams({ words, ...(before ? { before } : {}) }).toString();

export class Past {
  constructor({ judge, offer }) {
    this.judge = judge;
    this.offer = offer;
    this.said = [];
    this.more = false;
    this.due = 0;
    this.card = byId("past-details");
    this.words = byId("past-words");
    this.card.addEventListener("toggle", () => this.look());
    this.words.addEventListener("input", () => this.soon());
  }

  // Something was said or judged.
  changed() {
    // What a person types there is not taken away.
    if (!byId("past").contains(document.activeElement) || document.activeElement.tagName !== "INPUT") this.soon();
  }

  // A link to a moment names a command.
  find(id) {
    this.words.value = id;
    if (this.card.open) this.soon(); else this.card.open = true;
    this.card.scrollIntoView({ block: "nearest" });
    this.wanted = id;
  }

  soon() {
    clearTimeout(this.due);
    this.due = setTimeout(() => this.look(), WAIT_MS);
  }

  async look(before = 0) {
    if (!this.card.open) return;
    const words = this.words.value;
    try {
      const answer = await fetch(`past.json?${query(words, before)}`);
      if (!answer.ok) throw new Error(await answer.text());
      const found = await answer.json();
      if (words !== this.words.value) return;
      this.said = before ? [...this.said, ...found.said] : found.said;
      this.more = found.more;
      this.draw();
    } catch (error) {
      byId("past").replaceChildren(make("p", { class: "quiet bad" }, error.message || "No answer."));
    }
  }

  draw() {
    for (const file of document.querySelectorAll("#past-files a")) file.href = `${file.dataset.file}?${query(this.words.value)}`;
    keep(byId("past"), [this.said, this.more], () => [
      this.said.length ? make("ol", { class: "past" }, ...this.said.map((one) => make("li", { "data-id": one.id }, this.row(one))))
        : make("p", { class: "quiet" }, this.words.value ? "Nothing like that was said." : "Nothing was said yet."),
      this.more ? make("button", { type: "button", onclick: () => this.look(this.said[this.said.length - 1].stamp_s) }, "Earlier") : null,
    ]);
    if (this.wanted) {
      const row = byId("past").querySelector(`[data-id="${CSS.escape(this.wanted)}"] details`);
      if (row) row.open = true;
      this.wanted = "";
    }
  }

  row(one) {
    const verdict = (name, words) => make("button", {
      type: "button", "aria-pressed": String(one.verdict === name),
      onclick: () => this.judge(one.id, one.verdict === name ? "" : name, one.meant),
    }, words);
    const when = new Date(1000 * one.stamp_s).toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
    return make("details", { "data-key": one.id, class: one.verdict },
      make("summary", {}, make("span", { class: "first" }, one.text),
        one.verdict ? make("span", { class: "count" }, one.verdict) : null),
      make("p", { class: "quiet" }, when),
      make("p", { class: `robot ${one.outcome}` }, one.sentence),
      make("p", { class: "verdicts", role: "group", "aria-label": "Was it understood?" }, verdict("right", "Right"), verdict("wrong", "Wrong"),
        make("button", { type: "button", onclick: () => this.offer(one.text) }, "Say again"),
        make("a", { href: `#said=${encodeURIComponent(one.id)}` }, "Link")),
      ...(one.verdict === "wrong" ? this.meaning(one) : []));
  }

  meaning(one) {
    const input = make("input", { type: "text", "aria-label": "What did you mean?", placeholder: "What did you mean?", value: one.meant });
    const form = make("form", { class: "say", autocomplete: "off" }, input, make("button", { type: "submit" }, "Keep"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      input.blur();
      this.judge(one.id, "wrong", input.value.trim());
    });
    return [form, one.teaching ? make("button", { type: "button", class: "teach", onclick: () => this.offer(one.teaching) }, "Teach it") : null];
  }
}
