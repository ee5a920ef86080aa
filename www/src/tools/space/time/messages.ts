/** What is said of time and keyframes. */

export const time = "Time";
export const flyThrough = "Fly through";
export const loop = "Loop";
export const lastKeyframeAtVery =
  "The last keyframe is at the very end. If it differs from the first, the animation jumps back from there. “Back and forth” plays in reverse instead.";

export const moreOptionsForTime = "More options for time";
export const flyAround = "Fly around";
export const smoothAtKeyframes = "Smooth at the keyframes";
export const straightBetweenKeyframes = "Straight between keyframes";
export const halfSpeed = "Half speed";
export const doubleSpeed = "Double speed";
export const openSavedAnimation = "Open a saved animation …";
export const exportLabel = "Export …";
export const removeAllKeyframes = "Remove all keyframes";

export const moment = "Moment";
export const ofLabel = "of";
export const length = "Length";

export const smooth = "Smooth";
export const withoutJerksAtKeyframes = "Without jerks at the keyframes, and never past them";
export const straight = "Straight";
export const timeAndKeyframes = "Time and keyframes";
export const betweenKeyframes = "Between keyframes";
export const open = "Open …";
export const noAnimationYetThere = "No animation yet: there are no keyframes.";
export const thenEase = (ease: string) => `then ${ease}`;
export const deleteKey = (number: number) => `Delete keyframe ${number}`;

export const setTwoKeyframesOr = "set two keyframes, or fly through";
export const noAnimationYet = "No animation yet.";
export const setKeyframeMoveTo = "Set a keyframe, move to another time, change the view, set another.";
export const saveAsFilmAnimation = "Save it as a film, an animation or numbers";
export const filmPercent = (percent: number) => `Film ${percent}%`;

export const keyAfterEnd = (number: number, seconds: string) =>
  `Keyframe ${number} is at ${seconds} s. Move it first, or speed up the whole animation.`;

export const pressPlayToSee = " Press Play to see it.";
export const flightOf = (time: string, count: number, hint: string) =>
  `A flight of ${time} with ${count} keyframes.${hint}`;

export const easeFrom = (number: number, ease: string) => `From keyframe ${number} on: ${ease}`;
export const easeAfter = (number: number, ease: string) => `Easing after keyframe ${number}: ${ease}`;

export const keyOf = (number: number, count: number) => `Keyframe ${number} of ${count}`;
export const keysFull = (count: number) => `There are ${count} keyframes already`;
export const keepsViewPlaceEach = "Keeps the view, the place of each object and the morph at this moment";
export const setKeyframe2 = "Set keyframe";
export const keepCurrentStateAt = "keep the current state at this moment";
export const setKeyframeToThis = "Set keyframe to this view";

export const keyframes = "Keyframes";
export const keyAbout = (time: string, contents: string, ease: string) =>
  `${time}: ${contents}; then ${ease}`;
export const keyOfAt = (number: number, count: number, words: string) =>
  `Keyframe ${number} of ${count}, at ${words}`;
export const keyKeys = (number: number, words: string) =>
  `Keyframe ${number} at ${words}. Arrows move it, Delete removes it.`;

export const keysLimit = (count: number) => `There are ${count} keyframes already. Delete one first.`;
export const keySet = (number: number, count: number, time: string, contents: string) =>
  `Keyframe ${number} of ${count} at ${time}: ${contents}.`;
export const nothingMovesAnyMore = "Nothing moves any more, and everything stays in place.";
export const keysLeft = (count: number) => `${count} left.`;
export const allKeyframesRemovedAnd =
  "All keyframes are removed, and everything stays as it is now. Undo brings them back.";
export const thisWouldTooLong = "This would be too long, too short, or keyframes would meet.";
export const timelineNow = (time: string) => `The timeline is now ${time} long.`;

export const thisFileLargerThan =
  "This file is larger than 64 MB. Save it with fewer frames, or as “Shapes and keyframes”.";
export const thisFileDamagedSave = "This file is damaged. Save the animation again, and open that.";
export const opened = (name: string, what: string) => `Opened ${name}.${what}`;
export const eachFrame = (count: number) => ` Each of its ${count} frames is a keyframe.`;

export const thisFileContainsNo = "This file contains no frames.";
export const tooManyFrames = (count: number, most: number) =>
  `This file has ${count} frames; the limit is ${most}. Save fewer.`;
export const frameProblem = (number: number, problem: string) => `Frame ${number} of this file ${problem}`;
export const frameNotLater = (number: number) =>
  `Frame ${number} of this file is not later than the one before it.`;
export const frameObjects = (number: number, count: number, before: number) =>
  `Frame ${number} of this file has ${count} objects, but the one before it has ${before}. Each frame needs all objects.`;
export const hasTimeNotNumber = "has a time that is not a number of seconds.";
export const needsObjects = (most: number) => `does not have 1 to ${most} objects.`;
export const needsParameters = (number: number) =>
  `has no parameters for object ${number}. Each of its maps must be a list of 12 numbers.`;
export const objectOf = (number: number) => `Object ${number}`;
export const doesNotSayWhere =
  "does not say where it is seen from: an eye, a target, a turn, a tilt and an angle.";
export const tooManyKeys = (count: number, most: number) =>
  `These ${count} frames belong to no keyframes that Frond knows, or were changed. A timeline has at most ${most} keyframes, so leave out some frames.`;

export const thisNotJsonFile =
  "This is not a JSON file, or it is damaged. Choose one saved by the export of Space.";
export const thisFileContainsNoAnimation =
  "This file contains no animation of space. Choose one saved by the export of Space.";

export const atConstantSpeed = "At constant speed";
export const slowAtFirst = "Slow at first";
export const slowAtEnd = "Slow at the end";
export const slowAtBothEnds = "Slow at both ends";
export const holdThenJump = "Hold, then jump";
export const none2 = "None";
export const stopsAtEnd = "Stops at the end";
export const restart = "Restart";
export const startsAgainLastKeyframe =
  "Starts again: the last keyframe leads to the first, and jumps there from the very end";
export const backAndForth = "Back and forth";
export const playsInReverseFrom = "Plays in reverse from the end";
export const nothingMoves = (time: string) => `${time}, nothing moves`;
export const betweenKeyframes2 = "between keyframes";
export const keyCount = (number: number, count: number) => `keyframe ${number} of ${count}`;
export const momentOf = (now: string, all: string, key: string) => `${now} of ${all}, ${key}`;
export const view2 = "the view";
export const oneObject = "one object";
export const objectsMoved = (count: number) => `${count} objects`;
export const morphAt = (place: string) => `the morph at ${place}`;
export const nothingYet = "nothing yet";

export const loopIs = (loop: string) => `Loop: ${loop}`;
export const keyDeleted = (number: number, left: string) => `Keyframe ${number} deleted. ${left}`;
