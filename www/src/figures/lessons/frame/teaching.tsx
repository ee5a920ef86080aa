import css from "./teaching.module.css";

/** What a teacher wants to know of a lesson. */
export interface Teaching {
  /** What one can do after it that one could not before. */
  aim: string;
  /** What is often thought at first, and is not so. */
  mistakes: readonly string[];
  /** To ask a class, each with an answer. */
  questions: readonly { ask: string; answer: string }[];
}

/** For whoever teaches with it; folded away for those who learn. */
export function ForTeachers({ aim, mistakes, questions }: Teaching) {
  return (
    <details class={css["teaching"]}>
      <summary>For teachers</summary>
      <div>
        <h3>Aim</h3>
        <p>{aim}</p>
        <h3>Common mistakes</h3>
        <ul>
          {mistakes.map((mistake) => (
            <li key={mistake}>{mistake}</li>
          ))}
        </ul>
        <h3>Questions for the class</h3>
        <ol>
          {questions.map(({ ask, answer }) => (
            <li key={ask}>
              {ask} <em>{answer}</em>
            </li>
          ))}
        </ol>
      </div>
    </details>
  );
}
