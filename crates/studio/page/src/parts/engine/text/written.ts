// Between what stands in a field and what stands in the file. Units are the server's business: text stays text.

import type { KeyInfo } from "../../../api/types";

/** A value of the file. */
export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** As a field shows it: lists with commas. */
export function typed(value: unknown): string {
  if (Array.isArray(value)) return value.map(typed).join(", ");
  if (typeof value === "object" && value !== null) return JSON.stringify(value);
  return String(value);
}

/** Digits that count, of a number with more than `LONG` of them: what is computed and not typed. */
const SHORT = 5;
const LONG = 7;
const FRACTION = /^([+-]?)(\d*)\.(\d+)/;

/** A number with its unit, its digits behind the point no more than count. */
function short(text: string): string {
  return text.replace(FRACTION, (all, sign: string, whole: string, decimals: string) => {
    const leading = /^0*$/.test(whole) ? /^0*/.exec(decimals)![0].length : -whole.replace(/^0+/, "").length;
    if (decimals.length - leading <= LONG) return all;
    return sign + String(Number(Number(`${whole}.${decimals}`).toFixed(Math.max(0, SHORT + leading))));
  });
}

/** As a field shows it out of hand: numbers of the optimiser have more digits in the file than anybody reads. */
export function shownTyped(value: unknown): string {
  if (Array.isArray(value)) return value.map(shownTyped).join(", ");
  return typeof value === "number" || typeof value === "string" ? short(typed(value)) : typed(value);
}

/** Whether a field of one line can hold it. */
export function plain(value: unknown): boolean {
  if (Array.isArray(value)) return value.every((item) => typeof item !== "object");
  return typeof value !== "object" || value === null;
}

type Many = "one" | "list" | "either";

function many(key: KeyInfo): Many {
  if (/\bor a list\b|\bone or (two|three)\b/.test(key.wanted) || /pair|three/.test(key.kind)) return "either";
  return key.example.startsWith("[") ? "list" : "one";
}

/** Whether bare numbers are numbers in the file too, and not texts. */
function numeric(key: KeyInfo): boolean {
  return key.kind.includes("share") || !/^\[?\s*"/.test(key.example);
}

/** As the file is to hold what was typed. What does not fit is handed on as text: the server says what is wrong. */
export function written(key: KeyInfo | undefined, text: string): Json {
  const trimmed = text.trim();
  if (!key) return NUMBER.test(trimmed) ? Number(trimmed) : trimmed;
  const one = (item: string): Json => (numeric(key) && NUMBER.test(item) ? Number(item) : item);
  const how = many(key);
  if (how === "list" || (how === "either" && trimmed.includes(",")))
    return trimmed
      .replace(/^\[|\]$/g, "")
      .split(",")
      .map((item) => item.trim().replace(/^"|"$/g, ""))
      .filter((item) => item !== "")
      .map(one);
  return one(trimmed);
}

/** An example of the reference as a field shows it: without the quotes of the file. */
export function shownExample(example: string): string {
  return example.startsWith("{") || example.startsWith("[{")
    ? ""
    : example.replace(/^\[|\]$/g, "").replaceAll('"', "");
}
