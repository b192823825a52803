// The script of an exercise saved as one file.

import { ContactExercise } from "../contact-exercise.ts";
import { useFiles } from "./files.ts";

const base = document.querySelector("contact-exercise")?.getAttribute("base") ?? "./";
useFiles(new URL(base, document.baseURI).href);
customElements.define("contact-exercise", ContactExercise);
