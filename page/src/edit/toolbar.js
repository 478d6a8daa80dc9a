// Undo, redo, save, and what the program is doing.
const { both, element, pick, say, translated } = globalThis.cadgenPage;

export function toolbar({ step, saved }) {
  const make = (id, text, label, run) => {
    const button = element("button", { type: "button", id, text, label });
    button.addEventListener("click", run);
    return button;
  };
  const undo = make("undo", both("Undo"), both("Undo (Ctrl+Z)"), () => step("undo"));
  const redo = make("redo", both("Redo"), both("Redo (Ctrl+Y)"), () => step("redo"));
  const save = make("save", both("Save"), both("Save (Ctrl+S)"), () => store());
  const saveAs = make("save-as", both("Save as …"), both("Save under another name"), () => ask());
  document.querySelector(".tools").prepend(undo, redo, save, saveAs);
  const line = element("output", { id: "status", role: "status", "aria-live": "polite" });
  document.getElementById("verdict").after(line);

  let state = null;
  const dialog = naming((name) => saved(name));
  const ask = () => dialog.open(state);
  const store = async () => {
    if (state.copy) return ask();
    const sentence = await saved();
    return sentence ? dialog.open(state, sentence) : undefined;
  };

  let typed = null; // field with letters that are not sent yet
  addEventListener("input", ({ target }) => (typed = target.type === "range" ? null : target));
  addEventListener("change", () => (typed = null));
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || document.querySelector("dialog[open]")) return;
    const key = event.key.toLowerCase();
    const typing = typed === event.target; // its own undo is the browser's
    if (key === "s") {
      event.preventDefault();
      if (typing) event.target.dispatchEvent(new Event("change", { bubbles: true })); // what is typed is saved, too
      store();
    } else if (!typing && (key === "y" || (key === "z" && event.shiftKey))) {
      event.preventDefault();
      event.preventDefault();
      step("redo");
    } else if (!typing && key === "z") {
      event.preventDefault();
      event.preventDefault();
      step("undo");
    }
  });

  return {
    status: (text) => (line.textContent = text),
    show(now) {
      state = now;
      undo.disabled = !now.undo;
      redo.disabled = !now.redo;
      save.disabled = !now.unsaved && !now.copy;
      save.classList.toggle("due", now.unsaved);
    },
  };
}

/** The dialog that asks for a name. */
function naming(saved) {
  const input = element("input", { type: "text", id: "save-name", maxlength: 64, autocomplete: "off", spellcheck: "false" });
  const fault = element("p", { class: "fault", role: "alert" });
  const place = element("p", { class: "hint" });
  const [yes, no] = [element("button", { type: "button", class: "due", text: both("Save") }), element("button", { type: "button", text: both("Cancel") })];
  const dialog = element(
    "dialog",
    { id: "naming", label: both("Save under another name") },
    element("label", { for: "save-name", text: both("Name of the design and of its file") }),
    input,
    place,
    fault,
    element("div", { class: "buttons" }, yes, no),
  );
  document.body.append(dialog);
  let folder = "";
  const where = () => {
    const file = `${folder}/${input.value.trim().replace(/\.toml$/i, "") || "…"}.toml`;
    place.textContent = pick(both("The file will be {file}", { file }));
  };
  translated(where);
  const go = async () => {
    say(fault);
    const sentence = await saved(input.value.trim());
    if (sentence) say(fault, sentence);
    else dialog.close();
  };
  input.addEventListener("input", where);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter") go();
  });
  yes.addEventListener("click", go);
  no.addEventListener("click", () => dialog.close());
  return {
    open(state, sentence) {
      ({ folder } = state);
      input.value = `${state.name.slice(0, 60)}_2`;
      say(fault, sentence);
      where();
      dialog.showModal();
      input.select();
    },
  };
}
