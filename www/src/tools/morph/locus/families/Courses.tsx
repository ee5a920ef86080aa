import { Segmented } from "#ui/controls/Segmented";
import { type Course, course } from "./course";

/** Along which curve s goes when it is played. */
export function Courses() {
  return (
    <Segmented<Course>
      label="Where s goes"
      value={course.value}
      onChange={(next) => {
        course.value = next;
      }}
      options={[
        { value: "round", label: "Round", description: "About 0: the copies turn and keep their size" },
        { value: "ray", label: "Outwards", description: "From 0: the copies grow and keep their turn" },
      ]}
    />
  );
}
