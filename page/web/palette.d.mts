export const LIGHT: Readonly<Record<string, string>>;
export const DARK: Readonly<Record<string, string>>;
export const FORCED: Readonly<Record<string, string>>;
export const LEVELS_LIGHT: readonly (readonly string[])[];
export const LEVELS_DARK: readonly (readonly string[])[];
export const ROLES: readonly string[];
export const drawingRules: string;
export function levelVariables(levels: readonly (readonly string[])[]): string;
export function variables(colours: Readonly<Record<string, string>>): string;
