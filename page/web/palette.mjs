// The colours of drawings by role, once, for pages and for fallback pictures. Each text colour has
// a contrast of at least 4.5 with its background. No two roles differ in hue alone where they meet:
// dashes, labels and shapes tell them apart as well.

export const LIGHT = {
  paper: "#ffffff",
  ink: "#1c2128",
  muted: "#5b6470",
  ghost: "#c3cad3",
  ray: "#0a5cad",
  surface: "#41566f",
  normal: "#a3195b",
  hit: "#0f7040",
  miss: "#b3261e",
  a: "#a8430b",
  b: "#0b6e75",
  c: "#6b35b8",
  ball: "#8a5a00",
};

export const DARK = {
  paper: "#131416",
  ink: "#e8eaed",
  muted: "#a2abb6",
  ghost: "#3c434c",
  ray: "#74b8ff",
  surface: "#a9bdd4",
  normal: "#ff8fbd",
  hit: "#5fd696",
  miss: "#ff8b80",
  a: "#ffab70",
  b: "#56d0d9",
  c: "#c8a6ff",
  ball: "#f0c064",
};

/** A ladder's cells, from right to wrong: pale blue, then browner; each with the colour of its text. */
export const LEVELS_LIGHT = [
  ["#dcebf7", "#1c2128"],
  ["#fdf1d8", "#1c2128"],
  ["#fbd9a0", "#1c2128"],
  ["#f3ae5d", "#1c2128"],
  ["#d9752a", "#131416"],
  ["#8c2d04", "#ffffff"],
];
export const LEVELS_DARK = [
  ["#16324a", "#e8eaed"],
  ["#33291a", "#e8eaed"],
  ["#54401f", "#e8eaed"],
  ["#7d5519", "#ffffff"],
  ["#bd7820", "#131416"],
  ["#ffb861", "#131416"],
];

/** @param {readonly (readonly string[])[]} levels */
export const levelVariables = (levels) =>
  levels
    .map(([cell, text], i) => `--contact-level-${i}:${cell};--contact-on-level-${i}:${text};`)
    .join("");

/** Colours of the reader's own choosing. */
export const FORCED = Object.fromEntries(
  Object.keys(LIGHT).map((role) => [
    role,
    role === "paper" ? "Canvas" : role === "ghost" || role === "muted" ? "GrayText" : "CanvasText",
  ]),
);

export const ROLES = Object.keys(LIGHT).filter((name) => name !== "paper");

/** @param {Record<string, string>} colours */
export const variables = (colours) =>
  Object.entries(colours)
    .map(([name, colour]) => `--contact-${name}:${colour};`)
    .join("");

/** The rules that colour a drawing in these roles. @param {readonly string[]} roles */
export const drawingRules = (roles) => `
.line{fill:none;stroke-linecap:round;stroke-linejoin:round}
.line.dashed{stroke-dasharray:5 5}
.line.faint{opacity:.75}
.line.r-ghost.faint{opacity:1}
.face{stroke:none}
.face.outlined{stroke-width:1.6;stroke-linejoin:round}
.face.dashed{stroke-dasharray:5 5}
.dot{stroke:var(--contact-paper);stroke-width:1.5}
.dot.hollow{fill:var(--contact-paper)}
.label{font:600 14px system-ui,sans-serif;paint-order:stroke;stroke:var(--contact-paper);stroke-width:4px;stroke-linejoin:round}
.label.small{font-size:12px;font-weight:500}
${roles
  .map((role) => {
    const colour = `var(--contact-${role})`;
    return [
      `.line.r-${role}{stroke:${colour}}`,
      `.face.r-${role}{fill:${colour}}.face.outlined.r-${role}{stroke:${colour}}`,
      `.head.r-${role},.dot.r-${role},.label.r-${role}{fill:${colour}}`,
      `.dot.hollow.r-${role}{fill:var(--contact-paper);stroke:${colour};stroke-width:2}`,
    ].join("\n");
  })
  .join("\n")}
`;

/** The style of a picture that stands alone: of the roles that are drawn there. @param {string} drawn SVG */
export function pictureStyle(drawn) {
  const roles = ROLES.filter((role) => new RegExp(`\\br-${role}\\b`).test(drawn));
  const needed = ["paper", "ink", "muted", ...roles];
  const [light, dark] = [LIGHT, DARK].map((colours) =>
    variables(
      Object.fromEntries(Object.entries(colours).filter(([role]) => needed.includes(role))),
    ),
  );
  return (
    `svg{${light}}@media(prefers-color-scheme:dark){svg{${dark}}}@media print{svg{${light}}}` +
    `${drawingRules(roles)}.paper{fill:var(--contact-paper)}`
  );
}
