// Puts the page together: what can be read works at once, then the plan views and curves, then the assembly in 3D.
import { load, unpack } from "./data.js";
import { Motion } from "./motion.js";
import { courseMap } from "./course_map.js";
import { planViews } from "./views.js";
import { drawCharts } from "./charts.js";
import { transport } from "./transport.js";
import { both, element, fill, language, pick, remembered, say, speak, translated } from "./words.js";

const STILL = 300; // ms after the last move of the slider at which the picture is drawn in full
const root = document.documentElement;
const dark = matchMedia("(prefers-color-scheme: dark)");
let themed = () => {};
let printed = () => {};

function themes() {
  const choice = remembered("theme");
  if (choice) root.dataset.theme = choice;
  document.getElementById("theme").addEventListener("click", () => {
    const is = root.dataset.theme ?? (dark.matches ? "dark" : "light");
    root.dataset.theme = is === "dark" ? "light" : "dark";
    remembered("theme", root.dataset.theme);
    themed();
  });
  dark.addEventListener("change", () => themed());
}

function languages() {
  const button = document.getElementById("language");
  const show = (to) => {
    speak(to);
    button.textContent = to === "zh" ? "English" : "中文";
    button.lang = to === "zh" ? "en" : "zh";
    button.setAttribute("aria-label", to === "zh" ? "English: switch to English" : "中文：切换到中文");
    remembered("language", to);
  };
  button.addEventListener("click", () => show(language === "en" ? "zh" : "en"));
  const wanted = new URLSearchParams(location.hash.slice(1)).get("lang") ?? remembered("language") ?? root.dataset.language ?? navigator.language;
  if (wanted.startsWith("zh")) show("zh");
}

function trouble(words) {
  const line = document.getElementById("trouble");
  line.hidden = false;
  say(line, words);
}

const page = { map: null, bar: null, charts: null, assembly: null, fit: null, motion: null };

/** Shows a model, the first one or another in place of it: angle, camera and choices stay. */
async function present(data) {
  const motion = new Motion(data.scene, data.charts);
  page.motion = motion;
  page.bar ??= beginning();
  const { bar, charts } = page;
  bar.use(motion, data.marks);
  charts.use(data, motion);
  bar.listen("views", planViews(motion, page.map));
  if (page.assembly) {
    page.assembly.use(motion);
    page.fit();
  }
  bar.changed();
  if (page.assembly || root.dataset.without) return;
  root.dataset.ready = "plan";

  // The page can be used by now; the assembly comes in a task of its own.
  await new Promise((done) => setTimeout(done));
  if (page.assembly) return;
  try {
    const [{ Assembly }, { tools }] = [await import("./scene.js"), await import("./tools.js")];
    if (page.assembly) return;
    const assembly = new Assembly(document.getElementById("scene"), page.motion);
    assembly.wake = bar.wake;
    page.fit = tools(assembly);
    bar.listen("assembly", (state) => {
      assembly.show(state);
      assembly.moved?.();
    });
    page.assembly = assembly;
    bar.changed();
  } catch (error) {
    document.getElementById("assembly").classList.add("without");
    trouble(both("This browser has no WebGL, so the assembly in 3D is left out; everything else works."));
    root.dataset.without = String(error?.message ?? error).slice(0, 80);
  }
  root.dataset.ready = "all";
}

/** Slider and curves, and the loop that draws what moves. */
function beginning() {
  const bar = transport();
  page.charts = drawCharts(bar.set);
  bar.listen("charts", page.charts.show);
  const loop = { running: false, last: 0, sliding: -Infinity };
  const turn = (time) => {
    const since = time - loop.last;
    loop.last = time;
    const moving = bar.step(Math.min(since, 100)) || time - loop.sliding < STILL;
    page.assembly?.draw(moving, since);
    if (moving || page.assembly?.dirty) requestAnimationFrame(turn);
    else loop.running = false;
  };
  bar.wake = () => {
    if (loop.running) return;
    loop.running = true;
    loop.last = performance.now();
    requestAnimationFrame(turn);
  };
  document.getElementById("angle").addEventListener("input", () => {
    loop.sliding = performance.now();
    bar.wake();
  });
  themed = () => {
    page.charts.redraw();
    page.assembly?.colour();
    bar.changed();
  };
  printed = (on) => {
    if (on) root.dataset.printing = "";
    else delete root.dataset.printing;
    for (const folded of document.querySelectorAll("details.more")) {
      if (on) folded.dataset.was = String(folded.open);
      folded.open = on || folded.dataset.was === "true";
    }
    page.charts.print(on);
    page.map?.print(on);
    page.assembly?.colour();
    picture(page.assembly, on);
    bar.changed();
  };
  return bar;
}

/** Shows the data that stands in the page. */
async function own() {
  let data;
  try {
    data = await load();
  } catch {
    trouble(both("This browser cannot unpack the page's data: the model stands still, and the curves are left out. All tables are below."));
    return;
  }
  await present(data);
}

function picture(assembly, on) {
  const box = document.getElementById("scene");
  box.querySelector("img")?.remove();
  if (!on || !assembly) return;
  const image = new Image();
  image.alt = "";
  image.src = assembly.picture();
  image.decode?.().catch(() => {});
  box.append(image);
}

themes();
languages();
addEventListener("beforeprint", () => printed(true));
addEventListener("afterprint", () => printed(false));
document.getElementById("print").addEventListener("click", () => print());
page.map = courseMap();
const floor = document.getElementById("course-view");
if (floor) page.map.take(floor);
// A page that is served has no data of its own: its second script asks for them, and shows them by these functions.
globalThis.cadgenPage = { courseMap: page.map, both, present, unpack, element, fill, pick, say, translated };
if (document.getElementById("data")) own();
