import { type Option, Segmented } from "#ui/controls/Segmented";
import * as messages from "../messages";
import { sides } from "../view/view";
import { type Course, course, courseOf } from "./course";

const COURSES: readonly Option<Course>[] = [
  { value: "round", label: messages.around, description: messages.around0CopiesRotate },
  { value: "ray", label: messages.outwards, description: messages.awayFrom0Copies },
];
const SPIRAL: Option<Course> = {
  value: "spiral",
  label: messages.spiral,
  description: messages.intoLastLandmarkYou,
};

/** Along which curve s goes when it is played. */
export function Courses() {
  return (
    <Segmented<Course>
      label={messages.pathS}
      value={courseOf(sides.value)}
      onChange={(next) => {
        course.value = next;
      }}
      options={sides.value === 2 ? [...COURSES, SPIRAL] : COURSES}
    />
  );
}
