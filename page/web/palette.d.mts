export const LIGHT: Readonly<Record<string, string>>;
export const DARK: Readonly<Record<string, string>>;
export const FORCED: Readonly<Record<string, string>>;
export const ROLES: readonly string[];
export const drawingRules: string;
export function variables(colours: Readonly<Record<string, string>>): string;
