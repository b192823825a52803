// All questions, in the order of the table. A new group is a file in questions/ and a line here.

import { contacts } from "./questions/contacts.ts";
import { flight } from "./questions/flight.ts";
import { impacts } from "./questions/impacts.ts";
import { queries } from "./questions/queries.ts";
import { rays } from "./questions/rays.ts";
import { rotation } from "./questions/rotation.ts";
import type { Question } from "./types.ts";

export const QUESTIONS: readonly Question[] = [
  ...rays,
  ...queries,
  ...impacts,
  ...flight,
  ...rotation,
  ...contacts,
];
