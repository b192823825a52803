// The page's one script: it only names the elements. What an element needs it loads when it is used.

import { ContactEngines } from "./contact-engines.ts";
import { ContactExercise } from "./contact-exercise.ts";
import { ContactFigure } from "./contact-figure.ts";
import { ContactLadder } from "./contact-ladder.ts";
import { ContactPlayer } from "./contact-player.ts";
import { ContactQuestion } from "./contact-question.ts";

customElements.define("contact-figure", ContactFigure);
customElements.define("contact-question", ContactQuestion);
customElements.define("contact-ladder", ContactLadder);
customElements.define("contact-exercise", ContactExercise);
customElements.define("contact-player", ContactPlayer);
customElements.define("contact-engines", ContactEngines);
