import { type Option, Segmented } from "#ui/controls/Segmented";
import { sides } from "../view/view";
import { type Course, course, courseOf } from "./course";

const COURSES: readonly Option<Course>[] = [
  { value: "round", label: "Round", description: "About 0: the copies turn and keep their size" },
  { value: "ray", label: "Outwards", description: "From 0: the copies grow and keep their turn" },
];
const SPIRAL: Option<Course> = {
  value: "spiral",
  label: "Spiral",
  description: "Into the landmark that was gone to last, about which M looks like itself at every step",
};

/** Along which curve s goes when it is played. */
export function Courses() {
  return (
    <Segmented<Course>
      label="Where s goes"
      value={courseOf(sides.value)}
      onChange={(next) => {
        course.value = next;
      }}
      options={sides.value === 2 ? [...COURSES, SPIRAL] : COURSES}
    />
  );
}
