// The editor: CodeMirror with C++ and nothing that a beginner did not ask for. It is loaded when the
// reader first takes hold of the code.

import {
  defaultKeymap,
  history,
  historyKeymap,
  indentLess,
  indentMore,
} from "@codemirror/commands";
import { cppLanguage } from "@codemirror/lang-cpp";
import {
  bracketMatching,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from "@codemirror/language";
import { lintGutter, type Diagnostic as Mark, setDiagnostics } from "@codemirror/lint";
import { EditorSelection, EditorState, type Text } from "@codemirror/state";
import { EditorView, keymap, lineNumbers } from "@codemirror/view";
import { tagHighlighter, tags } from "@lezer/highlight";
import type { Diagnostic } from "../cpp/types.ts";
import { columnToOffset } from "./columns.ts";

export interface EditorOptions {
  readonly text: string;
  /** NAME.cpp: what the compiler says of other files is not marked. */
  readonly file: string;
  readonly label: string;
  /** The element that says which keys do what. */
  readonly describedBy: string;
  readonly changed: () => void;
  readonly check: () => void;
}

export interface Editor {
  readonly dom: HTMLElement;
  text(): string;
  replace(text: string): void;
  /** Marks what the compiler said, until it is told something else. */
  mark(messages: readonly Diagnostic[]): void;
  /** Puts the caret where the compiler points. */
  goTo(message: Diagnostic): void;
  /** Takes the focus, with the caret at this point of the window, if there is one. */
  focus(at?: { x: number; y: number }): void;
}

// The classes of the book's listings, which have the colours of both modes.
const inks = syntaxHighlighting(
  tagHighlighter([
    { tag: [tags.comment, tags.lineComment], class: "c1" },
    { tag: tags.blockComment, class: "cm" },
    { tag: [tags.processingInstruction, tags.meta], class: "cp" },
    { tag: [tags.string, tags.character, tags.special(tags.string)], class: "s" },
    { tag: tags.number, class: "mf" },
    { tag: [tags.bool, tags.null], class: "kc" },
    { tag: [tags.keyword, tags.modifier, tags.operatorKeyword, tags.self], class: "k" },
    { tag: tags.standard(tags.typeName), class: "kt" },
    {
      tag: [
        tags.arithmeticOperator,
        tags.logicOperator,
        tags.bitwiseOperator,
        tags.compareOperator,
        tags.updateOperator,
        tags.definitionOperator,
        tags.angleBracket,
      ],
      class: "o",
    },
  ]),
);

function rangeOf(doc: Text, message: Diagnostic): { from: number; to: number } {
  const place = (number: number, column: number): number => {
    const line = doc.line(Math.min(Math.max(number, 1), doc.lines));
    return line.from + columnToOffset(line.text, column);
  };
  const from = place(message.line, message.column);
  const to = Math.max(from, place(message.end_line, message.end_column));
  if (to > from) return { from, to };
  // A single place: the word there; where a line ends, its last letter, so that there is a mark.
  const line = doc.lineAt(from);
  const word = /^\w+|^\S/.exec(doc.sliceString(from, line.to));
  if (word) return { from, to: from + word[0].length };
  return { from: Math.max(line.from, from - 1), to: from };
}

/** Tab goes to the next stop; with a selection it moves the lines. */
function tab(view: EditorView): boolean {
  const { state } = view;
  if (state.selection.ranges.some((range) => !range.empty)) return indentMore(view);
  const change = state.changeByRange(({ head }) => {
    const blanks = " ".repeat(2 - ((head - state.doc.lineAt(head).from) % 2));
    return {
      changes: { from: head, insert: blanks },
      range: EditorSelection.cursor(head + blanks.length),
    };
  });
  view.dispatch(change, { scrollIntoView: true, userEvent: "input" });
  return true;
}

export function makeEditor(options: EditorOptions): Editor {
  const keys = keymap.of([
    {
      key: "Mod-Enter",
      run: () => {
        options.check();
        return true;
      },
    },
    { key: "Tab", run: tab, shift: indentLess },
    {
      key: "Escape",
      run: (editor) => {
        editor.setTabFocusMode(true);
        return false;
      },
    },
    ...defaultKeymap,
    ...historyKeymap,
  ]);
  const view = new EditorView({
    state: EditorState.create({
      doc: options.text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        history(),
        bracketMatching(),
        indentOnInput(),
        indentUnit.of("  "),
        EditorState.tabSize.of(2),
        cppLanguage,
        inks,
        keys,
        EditorView.contentAttributes.of({
          "aria-label": options.label,
          "aria-describedby": options.describedBy,
          tabindex: "0",
          autocapitalize: "off",
          autocorrect: "off",
          spellcheck: "false",
        }),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) options.changed();
          if (update.docChanged || (update.focusChanged && !update.view.hasFocus))
            update.view.setTabFocusMode(false);
        }),
      ],
    }),
  });
  return {
    dom: view.dom,
    text: () => view.state.sliceDoc(),
    replace(text) {
      const at = Math.min(view.state.selection.main.head, text.length);
      view.dispatch({
        changes: { from: 0, to: view.state.doc.length, insert: text },
        selection: { anchor: at },
        userEvent: "input.replace",
      });
    },
    mark(messages) {
      const marks = messages
        .filter(({ file, severity }) => file.endsWith(options.file) && severity !== "note")
        .filter(({ line }) => line > 0)
        .map((message): Mark => {
          const severity = message.severity === "error" ? "error" : "warning";
          return { ...rangeOf(view.state.doc, message), severity, message: message.words };
        });
      view.dispatch(setDiagnostics(view.state, marks));
    },
    goTo(message) {
      const { from } = rangeOf(view.state.doc, message);
      view.dispatch({ selection: { anchor: from }, scrollIntoView: true });
      view.focus();
    },
    focus(at) {
      const place = at && view.posAtCoords(at);
      if (place !== null && place !== undefined) view.dispatch({ selection: { anchor: place } });
      view.focus();
    },
  };
}
