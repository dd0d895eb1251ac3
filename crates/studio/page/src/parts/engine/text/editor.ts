// The text of the engine file in CodeMirror; loaded when the Engine tab is seen first.

import { defaultKeymap, indentWithTab } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, bracketMatching, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { type Diagnostic, lintGutter, setDiagnostics } from "@codemirror/lint";
import { EditorState, StateEffect, StateField, Transaction } from "@codemirror/state";
import {
  Decoration,
  type DecorationSet,
  EditorView,
  drawSelection,
  highlightActiveLine,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { PlacedDiagnostic } from "../../../api/types";

export interface Editor {
  /** Takes a text from elsewhere: only what differs is replaced, the cursor stays. */
  setText(text: string): void;
  setDiagnostics(found: PlacedDiagnostic[]): void;
  /** Lights up places of the text and brings the first into the editor's view. */
  mark(places: [number, number][]): void;
  /** Puts the cursor to a place. */
  show(at: number): void;
  destroy(): void;
}

export interface Listener {
  changed(text: string): void;
  undo(): void;
  redo(): void;
  /** The cursor stands here. */
  placed(at: number): void;
}

const style = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--series-3)" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--series-2)" },
  { tag: [tags.propertyName, tags.variableName], color: "var(--series-1)" },
  { tag: tags.heading, color: "var(--series-4)", fontWeight: "600" },
]);

const theme = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--panel)", fontSize: "13px" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-scroller": { fontFamily: 'ui-monospace, "SF Mono", Menlo, Consolas, monospace', lineHeight: "1.55" },
  ".cm-content": { caretColor: "var(--ink)", padding: "6px 0" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--quiet)", border: "0" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--sunk)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "var(--accent-ground)",
  },
  ".cm-in-hand": {
    backgroundColor: "var(--accent-ground)",
    outline: "1px solid var(--accent)",
    borderRadius: "3px",
  },
  ".cm-tooltip": {
    backgroundColor: "var(--panel)",
    color: "var(--ink)",
    border: "1px solid var(--line)",
    borderRadius: "6px",
    boxShadow: "var(--shadow)",
  },
  ".cm-diagnostic": { fontFamily: "inherit", padding: "6px 10px", whiteSpace: "pre-line", maxWidth: "420px" },
});

const setMarks = StateEffect.define<[number, number][]>();
const inHand = Decoration.mark({ class: "cm-in-hand" });
const marks = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(old, transaction) {
    let now = old.map(transaction.changes);
    for (const effect of transaction.effects)
      if (effect.is(setMarks))
        now = Decoration.set(
          effect.value.filter(([from, to]) => from < to).map(([from, to]) => inHand.range(from, to)),
          true,
        );
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** Where two texts differ: `from` to `to` of the old one is replaced by `insert`. */
export function replacement(before: string, after: string) {
  let from = 0;
  while (from < before.length && from < after.length && before[from] === after[from]) from += 1;
  let tail = 0;
  const most = Math.min(before.length, after.length) - from;
  while (tail < most && before[before.length - 1 - tail] === after[after.length - 1 - tail]) tail += 1;
  return { from, to: before.length - tail, insert: after.slice(from, after.length - tail) };
}

// The editor counts an end of line as one sign; a file of another system may have two.

/** The editor's text with the line ends of the file as it was. */
export function withEnds(text: string, file: string): string {
  return file.includes("\r\n") ? text.replaceAll("\n", "\r\n") : text;
}

export function inEditor(file: string, at: number): number {
  return at - (file.slice(0, at).match(/\r\n/g)?.length ?? 0);
}

export function inFile(file: string, at: number): number {
  if (!file.includes("\r\n")) return at;
  const before = file.replaceAll("\r\n", "\n").slice(0, at);
  return at + (before.match(/\n/g)?.length ?? 0);
}

export function makeEditor(host: HTMLElement, text: string, listener: Listener): Editor {
  /** The text as the file has it, with its own line ends. */
  let source = text;
  const act = (what: () => void) => () => {
    what();
    return true;
  };
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        drawSelection(),
        highlightActiveLine(),
        bracketMatching(),
        StreamLanguage.define(toml),
        syntaxHighlighting(style),
        theme,
        marks,
        EditorView.contentAttributes.of({ "aria-label": "Text of the engine file", spellcheck: "false" }),
        keymap.of([
          // Undo is the engine's own: it knows the form and the sliders too.
          { key: "Mod-z", run: act(listener.undo), preventDefault: true },
          { key: "Mod-y", run: act(listener.redo), preventDefault: true },
          { key: "Mod-Shift-z", run: act(listener.redo), preventDefault: true },
          // Tab leaves the editor once Escape was pressed, as CodeMirror has it.
          indentWithTab,
          ...defaultKeymap,
        ]),
        EditorView.updateListener.of((update) => {
          const own = update.transactions.some((one) => one.annotation(Transaction.remote) !== true);
          if (update.docChanged && own) {
            source = withEnds(update.state.sliceDoc(), source);
            listener.changed(source);
          }
          if (update.view.hasFocus && (update.selectionSet || update.docChanged))
            listener.placed(inFile(source, update.state.selection.main.head));
        }),
      ],
    }),
  });
  /** A place of the file's text as the editor counts it. */
  const clamp = (at: number) => Math.max(0, Math.min(view.state.doc.length, inEditor(source, at)));
  return {
    setText(next) {
      if (next === source) return;
      source = next;
      const changes = replacement(view.state.sliceDoc(), next.replaceAll("\r\n", "\n"));
      view.dispatch({ changes, annotations: Transaction.remote.of(true) });
    },
    setDiagnostics(found) {
      const shown = found.map((one): Diagnostic => {
        const from = clamp(one.span.start);
        return {
          from,
          to: Math.max(from, clamp(one.span.end)),
          severity: one.severity,
          message: one.hint ? `${one.message}\nHint: ${one.hint}` : one.message,
          source: one.code,
        };
      });
      view.dispatch(setDiagnostics(view.state, shown));
    },
    mark(places) {
      const within = places.map(([from, to]): [number, number] => [clamp(from), clamp(to)]);
      const first = within[0];
      view.dispatch({ effects: setMarks.of(within) });
      // The editor's own text moves and not the page: the eye is on the field.
      if (first && !view.hasFocus) {
        const { top, bottom } = view.lineBlockAt(first[0]);
        const { scrollTop, clientHeight } = view.scrollDOM;
        if (top < scrollTop || bottom > scrollTop + clientHeight)
          view.scrollDOM.scrollTop = (top + bottom - clientHeight) / 2;
      }
    },
    show(at) {
      view.dispatch({
        selection: { anchor: clamp(at) },
        effects: EditorView.scrollIntoView(clamp(at), { y: "center" }),
      });
      view.focus();
    },
    destroy: () => view.destroy(),
  };
}
