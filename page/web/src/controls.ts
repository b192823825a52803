// The numbers of a figure beside its drawing: typed, slid, chosen, played.

import { button, html, symbol } from "./dom.ts";
import type { Control } from "./figure.ts";
import type { Fields } from "./layout.ts";
import { measure } from "./measure.ts";
import type { FigureModel } from "./model.ts";

type AnyControl = Control<Fields>;
type Kind<K extends AnyControl["kind"]> = Extract<AnyControl, { kind: K }>;

const XYZ = ["x", "y", "z"];

export interface ControlsPart {
  readonly element: HTMLElement;
  refresh(): void;
}

export function makeControls(model: FigureModel): ControlsPart {
  const refreshers: (() => void)[] = [];
  const controls = model.figure.controls as readonly AnyControl[];
  const vectors = controls.filter(
    (control): control is Kind<"numbers"> =>
      control.kind === "numbers" && model.size(control.field) > 1,
  );
  const element = html("div", { class: "inputs" });
  for (const control of controls) {
    if (control.kind === "choice") element.append(choice(control, model, refreshers));
    else if (control.kind === "states") element.append(states(control, model));
    else if (control.kind === "measure") element.append(measurer(control, model));
    else if (model.size(control.field) === 1) element.append(row(control, model, refreshers));
  }
  const groups = new Map<string, Kind<"numbers">[]>();
  for (const control of vectors) {
    const heads = (control.axes ?? XYZ).join();
    groups.set(heads, [...(groups.get(heads) ?? []), control]);
  }
  for (const group of groups.values()) element.append(table(group, model, refreshers));
  return { element, refresh: () => refreshers.forEach((again) => void again()) };
}

function table(
  controls: readonly Kind<"numbers">[],
  model: FigureModel,
  refreshers: (() => void)[],
): HTMLElement {
  const size = Math.max(...controls.map(({ field }) => model.size(field)));
  const axes = (controls[0]?.axes ?? XYZ).slice(0, size);
  const head = html("tr", {}, html("th", { scope: "col" }, "Given"));
  for (const axis of axes) head.append(html("th", { scope: "col" }, html("var", {}, axis)));
  const body = html("tbody");
  for (const control of controls) {
    const name = symbol(control.label, control.role ? `t-${control.role}` : "");
    const cells = html("tr", {}, html("th", { scope: "row" }, name));
    for (const [i, axis] of axes.entries()) {
      const input = number(model, control.field, i, `${control.label}, ${axis}`, control.step);
      refreshers.push(input.refresh);
      cells.append(html("td", {}, input.element));
    }
    body.append(cells);
  }
  return html(
    "table",
    { class: "given", "aria-label": "Numbers of the figure" },
    html("thead", {}, head),
    body,
  );
}

function row(
  control: Kind<"numbers"> | Kind<"slider">,
  model: FigureModel,
  refreshers: (() => void)[],
): HTMLElement {
  const { field, label, step, unit } = control;
  const typed = number(model, field, 0, label, step);
  refreshers.push(typed.refresh);
  const line = html("div", { class: "row" }, html("span", { class: "name" }, symbol(label)));
  if (control.kind === "slider") {
    const slider = html("input", {
      type: "range",
      min: String(control.min),
      max: String(control.max),
      step: String(control.step),
      "aria-label": label,
    });
    slider.addEventListener("input", () => model.setNumber(field, 0, Number(slider.value)));
    refreshers.push(() => {
      slider.value = String(model.numbers(field)[0]);
    });
    line.append(slider);
    if (control.play) line.append(player(control, control.play, model));
  }
  line.append(typed.element);
  if (unit) line.append(html("span", { class: "unit" }, unit));
  return line;
}

/** A field for one number. What cannot be read as one is marked and changes nothing. */
function number(
  model: FigureModel,
  field: string,
  index: number,
  label: string,
  step = 0.1,
): ControlsPart & { readonly element: HTMLInputElement } {
  const element = html("input", { type: "number", step: "any", "aria-label": label });
  element.dataset.field = field;
  element.dataset.index = String(index);
  const take = (): void => {
    const good = element.value !== "" && Number.isFinite(element.valueAsNumber);
    element.toggleAttribute("aria-invalid", !good);
    if (good) model.setNumber(field, index, element.valueAsNumber);
  };
  element.addEventListener("input", take);
  element.addEventListener("blur", () => refresh());
  element.addEventListener("keydown", (event) => {
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (!sign) return;
    event.preventDefault();
    const size = step * (event.shiftKey ? 10 : 1) * (event.altKey ? 0.1 : 1);
    const value = model.numbers(field)[index]! + sign * size;
    model.setNumber(field, index, Math.round(value * 1e6) / 1e6 + 0);
  });
  const refresh = (): void => {
    const value = model.numbers(field)[index]!;
    const typing = document.activeElement === element && element.value !== "";
    if (typing && element.valueAsNumber === value) return;
    if (element.hasAttribute("aria-invalid") && document.activeElement === element) return;
    element.removeAttribute("aria-invalid");
    element.value = String(value);
  };
  return { element, refresh };
}

function choice(
  control: Kind<"choice">,
  model: FigureModel,
  refreshers: (() => void)[],
): HTMLElement {
  const select = html("select", { "aria-label": control.label });
  for (const { value, label } of control.options)
    select.append(html("option", { value: String(value) }, label));
  select.addEventListener("change", () => model.setNumber(control.field, 0, Number(select.value)));
  refreshers.push(() => {
    const value = String(model.numbers(control.field)[0]);
    // A ladder or a link may give a number that is none of the choices; it is shown as it is.
    select.querySelector("option.given")?.remove();
    if (![...select.options].some((option) => option.value === value))
      select.append(html("option", { value, class: "given" }, value));
    select.value = value;
  });
  return html("div", { class: "row" }, html("span", { class: "name" }, control.label), select);
}

function states(control: Kind<"states">, model: FigureModel): HTMLElement {
  const name = html("span", { class: "name" }, control.label);
  const buttons = control.options.map(({ label, fields }) =>
    button(label, () => model.set(fields as Fields)),
  );
  return html(
    "div",
    { class: "row states", role: "group", "aria-label": control.label },
    name,
    ...buttons,
  );
}

/** Starts measuring, or stops it. */
function measurer(control: Kind<"measure">, model: FigureModel): HTMLElement {
  let running: AbortController | undefined;
  const stop = (): void => {
    running?.abort();
    running = undefined;
    toggle.textContent = control.label;
  };
  const start = async (): Promise<void> => {
    const mine = new AbortController();
    running = mine;
    toggle.textContent = "Stop";
    await measure(control, model, () => mine.signal.aborted || !toggle.isConnected);
    if (running === mine) stop();
  };
  const toggle = button(control.label, () => (running ? stop() : void start()));
  return html("div", { class: "row states" }, toggle);
}

/** Plays a slider from where it is to its end. Where motion is unwelcome there is no such button. */
function player(control: Kind<"slider">, seconds: number, model: FigureModel): HTMLButtonElement {
  let frame = 0;
  const speed = (control.max - control.min) / (seconds * 1000);
  const stop = (): void => {
    cancelAnimationFrame(frame);
    frame = 0;
    toggle.textContent = "Play";
  };
  const start = (): void => {
    const now = model.numbers(control.field)[0]!;
    const from = now < control.max ? Math.max(now, control.min) : control.min;
    const began = performance.now();
    toggle.textContent = "Stop";
    const tick = (time: number): void => {
      const value = Math.min(control.max, from + Math.max(0, time - began) * speed);
      model.setNumber(control.field, 0, Math.round(value * 1000) / 1000);
      if (value >= control.max || !toggle.isConnected) stop();
      else frame = requestAnimationFrame(tick);
    };
    frame = requestAnimationFrame(tick);
  };
  const toggle = button("Play", () => (frame ? stop() : start()), "play");
  return toggle;
}
