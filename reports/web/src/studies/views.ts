// The view of each study, by its name.
import type { Study, StudyView } from "../study";
import { baseline } from "./baseline";
import { history } from "./history";
import { model } from "./model";
import { speed } from "./speed";
import { stability } from "./stability";

const views: Record<string, (study: Study) => StudyView> = { baseline, history, model, speed, stability };

/** A study without a view of its own still shows how its points ended. */
export const view_of = (study: Study): StudyView => (views[study.study] ?? (() => ({ sentence: study.about, sections: [] })))(study);
