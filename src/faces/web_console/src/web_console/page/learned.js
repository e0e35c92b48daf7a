// What persons taught the robot, each with a button that forgets it.

import { keep, make } from "./dom.js";

const byId = (id) => document.getElementById(id);

export function drawLearned(view, say) {
  byId("learned-card").hidden = !view.items.length;
  const about = (one) => [one.who ? `by ${one.who}` : "", new Date(1000 * one.when_s).toLocaleString(), `in "${one.sentence}"`]
    .filter((part) => part).join(", ");
  keep(byId("learned"), view, () => [
    make("ul", { class: "nodes" }, ...view.items.map((one) => make("li", {},
      make("b", {}, one.meaning), make("span", { class: "quiet" }, about(one)),
      make("button", { type: "button", "aria-label": `Forget "${one.said}"`, onclick: () => say(one.forgets) }, "Forget")))),
    view.more ? make("p", { class: "quiet" }, `and ${view.more} more`) : null,
  ]);
}
