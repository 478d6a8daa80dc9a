// Edits the design: sends changes one after the other, and shows the results as they come, the newest alone.
import { ask, askForResult } from "./ask.js";
import { controls } from "./controls.js";
import { handles } from "./handles.js";
import { timing } from "./timing.js";
import { toolbar } from "./toolbar.js";

const { both, element, fill, pick, present, say, translated, unpack } = globalThis.cadgenPage;
const root = document.documentElement;

let state = null; // of the server's design, after the last change that it took
let whole = null; // data of the last whole result: a preview has the cam alone
const visit = Math.random().toString(36).slice(2); // moves of another page, or of this one before it was opened anew, are others
let pending = null; // change that waits for the one before
let sending = false;
let posted = Promise.resolve(); // the last request that acts: they go one after the other
let elsewhere = false; // whether the newest change was made on another page, and is not shown yet
let place = null; // shows a sentence where the last change was made
const shown = { preview: 0, whole: 0 }; // revisions
// Functions that take a sentence away. A refusal stays until a change is taken: a result that was on its way
// when the change was refused says nothing of it. A fault of a result stays until there is a result.
const said = { refusal: new Set(), fault: new Set() };

const STATES = {
  computing: both("computing …"),
  elsewhere: both("changed in another tab: these numbers are old, computing …"),
  preview: both("preview: actual profile"),
  whole: both("up to date"),
  fault: both("the last good part is shown"),
  none: both("cannot be computed"),
  gone: both("cadgen edit has ended, or cannot be reached: start it again. What is not saved stays on this page until you close it."),
};

const bar = toolbar({ step, saved: (name) => act("save", name ? { name } : {}) });
const panel = controls(document.getElementById("edit"), change);
// A car has its course, and a cam by its motion the timing diagram.
const course = document.getElementById("course-figure");
const floor = course && handles(course, change, step);
const diagram = course ? null : timing(document.getElementById("timing-figure"), change, step);
const general = element("p", { id: "general-fault", class: "fault", role: "alert" });
document.getElementById("edit").prepend(general);
let status = "computing";
translated(() => bar.status(pick(STATES[status])));

function tell(code) {
  status = code;
  root.dataset.state = code;
  bar.status(pick(STATES[code]));
}

/** Takes a state of the server's: all numbers, points and buttons follow it. */
function take(answer) {
  state = answer;
  bar.show(state);
  panel.show(state);
  floor?.show(state);
  diagram?.show(state);
  document.title = `${state.unsaved ? "• " : ""}${state.name} · cadgen`;
  document.querySelector("h1 span").textContent = state.name;
  if (state.revision > shown.whole) root.dataset.stale = "";
}

function unsay(...kinds) {
  for (const kind of kinds) {
    for (const clear of said[kind]) clear();
    said[kind].clear();
  }
}

/** Shows a sentence where the change was made, or above the controls. */
function complain(kind, sentence, where) {
  unsay("fault", ...(kind === "refusal" ? [kind] : []));
  said[kind].add((where ?? inGeneral)(sentence));
}

function inGeneral(sentence) {
  say(general, sentence);
  return () => say(general);
}

/**
 * Sends a change, or lets it wait for the one before; of changes that wait, the last value of each key counts.
 * `settled` ends a move: the whole result is then computed, too. `where` shows a sentence at its place.
 */
async function change({ changes, gesture, settled, where }) {
  pending = { changes: { ...pending?.changes, ...changes }, gesture, settled: settled || Boolean(pending?.settled), where };
  if (sending) return;
  sending = true;
  while (pending) {
    const now = pending;
    const taken = await flush();
    const preview = taken ? show("preview") : null;
    if (now.settled) show("whole");
    await preview;
  }
  sending = false;
}

/** Sends the change that waits; returns whether the server has taken it. */
function flush() {
  return post(async () => {
    const now = pending;
    pending = null;
    if (!now) return true;
    place = now.where;
    try {
      if (Object.keys(now.changes).length) take(await ask("change", { changes: now.changes, gesture: `${visit} ${now.gesture}` }));
      unsay("refusal");
      return true;
    } catch (error) {
      fail("refusal", error, now.where);
      if (now.settled && state) take(state);
      return false;
    }
  });
}

/** Does something after what was begun before it. */
function post(work) {
  const done = posted.then(work);
  posted = done.catch(() => undefined);
  return done;
}

/** Undoes, redoes, saves, adds or removes a point; returns a sentence if that is refused. */
async function act(what, body = {}) {
  const before = state.revision;
  await flush();
  try {
    await post(async () => take(await ask(what, body)));
    place = null;
    if (state.revision !== before) {
      unsay("refusal", "fault");
      results();
    }
    return null;
  } catch (error) {
    if (error.status === undefined) fail("refusal", error, null);
    return error.said;
  }
}

/** The same, where nobody else shows the sentence. */
async function step(what, body, where) {
  const sentence = await act(what, body);
  if (sentence && root.dataset.state !== "gone") complain("refusal", sentence, where);
  return !sentence;
}

const results = () => Promise.all([show("preview"), show("whole")]);

/** Asks for a result of the design as it is now, and shows it, unless something newer is there by then. */
async function show(stage) {
  const { revision } = state;
  if (shown[stage] === revision) return;
  tell(elsewhere ? "elsewhere" : "computing");
  const where = place;
  try {
    const answer = await askForResult(stage, revision);
    const data = await unpack(answer.document, answer.block);
    if (revision < Math.max(shown.whole, shown.preview) || (stage === "preview" && shown.whole >= revision)) return;
    if (revision !== state.revision && stage === "whole") return;
    shown[stage] = revision;
    if (stage === "whole") whole = data;
    else if (whole) withGears(data.scene, whole.scene);
    lay(answer.pieces);
    diagram?.curve(data.scene);
    await present(data);
    root.dataset[stage] = revision;
    if (revision !== state.revision) return;
    unsay("fault");
    if (stage === "whole") {
      delete root.dataset.stale;
      elsewhere = false;
    }
    tell(elsewhere ? "elsewhere" : stage);
  } catch (error) {
    if (revision !== state.revision) return;
    if (error.status === 409) {
      await follow();
      return;
    }
    if (error.floor && !shown.preview && !shown.whole) {
      lay({ "course-box": error.floor });
    }
    fail("fault", error, where);
  }
}

/** Takes the design as another page has left it. */
async function follow() {
  const { revision } = state;
  const answer = await ask("state");
  if (sending || revision !== state.revision) return; // this page's own change has brought it
  take(answer);
  if (answer.revision === revision) return;
  elsewhere = true;
  await results();
}

const NEWS = 2000; // ms from question to question whether another page has changed something
const outside = element("p", { id: "changed-outside", class: "fault", role: "status" });
let asking = false;

/** Asks what is new as long as the page is seen: another page may have changed the design or saved it, another program the file. */
async function news() {
  if (asking || sending || document.hidden || !state || root.dataset.state === "gone") return;
  asking = true;
  try {
    const { revision, file, unsaved, changed_outside } = await ask("news");
    say(outside, changed_outside ? both("{file} was changed by another program: the numbers here are those before. Open the design again, or save under another name.", { file }) : undefined);
    if (!sending && (revision > state.revision || unsaved !== state.unsaved || file !== state.file)) await follow();
  } catch (error) {
    fail("refusal", error, null);
  } finally {
    asking = false;
  }
}

/** A preview's scene with the shafts and gears of the last whole one. */
function withGears(scene, last) {
  scene.parts = [...scene.parts, ...last.parts.filter(({ shaft }) => shaft > 0)];
  scene.shafts = last.shafts;
  scene.wheel = last.wheel;
}

function lay(pieces) {
  for (const [id, html] of Object.entries(pieces)) {
    const node = document.getElementById(id);
    if (id === "course-box") {
      // The points above it are being dragged: only the drawing under them changes.
      const made = document.createElement("div");
      fill(made, html);
      floor?.ground(made.firstElementChild);
    } else if (node) fill(node, html);
  }
  document.getElementById("failures")?.setAttribute("tabindex", "0"); // it scrolls, by keys too
}

function fail(kind, error, where) {
  if (error.status === undefined) {
    tell("gone");
    complain("refusal", STATES.gone, null);
    return;
  }
  tell(shown.preview || shown.whole ? "fault" : "none");
  complain(kind, error.said, where);
}

document.getElementById("edit").prepend(outside);
setInterval(news, NEWS);
document.addEventListener("visibilitychange", news);

addEventListener("beforeunload", (event) => {
  if (state?.unsaved) event.preventDefault();
});

tell("computing");
ask("state").then((answer) => {
  take(answer);
  results();
}, (error) => fail("fault", error, null));
