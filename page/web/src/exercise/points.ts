/** Points without needless digits. */
export const number = (value: number): string => `${Number(value.toFixed(2))}`;
