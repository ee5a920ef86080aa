import type { ComponentChildren } from "preact";
import { Choices, type ChoicesProps, Reply } from "./choices";
import { Question, type QuestionProps, Truth } from "./lesson";

interface ChoiceQuestionProps<T extends string>
  extends ChoicesProps<T>,
    Pick<QuestionProps, "beside" | "after"> {
  /** The truth, in a line. */
  line: ComponentChildren;
  /** Why it is so. */
  children: ComponentChildren;
}

/** A question with a few answers: what is guessed is answered for itself, and then comes the truth, with its reason. */
export function ChoiceQuestion<T extends string>(props: ChoiceQuestionProps<T>) {
  const { ask, options, prediction, truth, line, children, beside, after } = props;
  return (
    <Question
      prediction={prediction}
      truth={truth}
      beside={beside}
      after={after}
      answer={
        <>
          <Reply options={options} prediction={prediction} truth={truth} />
          <Truth line={line}>{children}</Truth>
        </>
      }
    >
      <Choices<T> ask={ask} options={options} prediction={prediction} truth={truth} />
    </Question>
  );
}
