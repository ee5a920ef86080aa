import type { Context as Plain } from "../lanes/task";
import type { FitModule } from "./module";

/** What a task of the fit has at hand. */
export interface Context<Progress = never> extends Plain<Progress> {
  readonly fit: FitModule;
}
