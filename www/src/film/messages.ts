/** What films and pictures of any size say while they are chosen and made. */
import { counted } from "#format/plural";

export const filmInProgress = "The film in progress";
export const watchFilmWhileRenders = "Watch the film while it renders";
export const film = "Film";
export const framesRendered = "Frames rendered";
export const leftIs = (time: string) => `About ${time} left`;
export const cancelFilm = "Cancel the film";
export const film2 = "The film";
export const filmInYourDownloads = "The film is in your downloads.";
export const open = "Open";
export const dismiss = "Dismiss";

export const exportLabel = "Export";
export const nothingHereCanFilmed =
  "Nothing here can be filmed. Open Morph, Deform or Space, and make the film there.";
export const youCanCloseThis =
  "You can close this window; rendering continues. The header shows the progress.";
export const inYourDownloads = "It is in your downloads.";
export const everyFrameCompleteHowever = "Every frame is complete, however long it takes.";
export const numbersInsteadPixelsEach = "Numbers instead of pixels: each frame is a set of parameters.";
export const preparing = "Preparing …";

export const frameAside = (count: string) => `, ${count} frames`;
export const makeAnother = "Make another";
export const saveAgain = "Save again";

export const background = "Background";
export const asHere = "As here";
export const paper = "Paper";
export const night = "Night";
export const custom = "Custom";
export const transparent = "Transparent";
export const backgroundColour = "Background colour";

export const frameNumber = (number: number) => `Frame ${number}`;
export const noFrameYet = "No frame yet";
export const cancel = "Cancel";

export const startsWith = "Starts with";

export const small = "Small";
export const good = "Good";
export const best = "Best";
export const none = "None";
export const stopsAtEnd = "Stops at the end";
export const restart = "Restart";
export const startsAgainWithoutJump = "Starts again without a jump if the end looks like the start";
export const backAndForth = "Back and forth";
export const playsInReverseFrom = "Plays in reverse from the end: a loop without a jump";
export const linear = "Linear";
export const sameSpeedThroughout = "The same speed throughout";
export const easeInAndOut = "Ease in and out";
export const startsSlowlyAndSlows = "Starts slowly and slows down before the end";
export const fourPixelsShareOne = "Four pixels share one colour: plays almost everywhere";
export const everyPixelHasOwn = "Every pixel has its own colour: crisp edges";
export const jaggedEdgesFastest = "Jagged edges, fastest";
export const smoothEdges = "Smooth edges";
export const smoothestEdgesInAbout = "The smoothest edges, in about four times the time";
export const auto = "Auto";
export const onlyWhereFilmHas = "Only where the film has more shades than 256 colours can show";
export const on = "On";
export const mixesColoursWithDots = "Mixes colours with dots: smoother shades, larger file";
export const off = "Off";
export const flatColoursSmallerFile = "Flat colours, smaller file";
export const firstFrame = "First frame";
export const renderFilm = "Render the film";
export const save = "Save";
export const film3 = "Film of";
export const format = "Format";
export const videoPlaysAlmostEverywhere = "A video that plays almost everywhere";
export const videoForWebWith = "A video for the web, with transparency where possible";
export const animationIn256Colours = "An animation in 256 colours, for messages and old programs";
export const animationInFullColour = "An animation in full colour, with transparency where possible";
export const frames = "Frames";
export const everyFrameAsPng = "Every frame as a PNG, in one ZIP file";
export const numbersParametersNotPixels = "Numbers: parameters, not pixels";
export const thisBrowserHasNo =
  "This browser has no WebCodecs, so it cannot write videos. The other formats work.";
export const cannotWrite = (formats: string) => `This browser cannot write ${formats} at this size.`;
export const framesPerSecond = "Frames per second";
export const length = "Length";
export const loop = "Loop";
export const easing = "Easing";
export const pauseAtBothEnds = "Pause at both ends";
export const quality = "Quality";
export const chroma = "Chroma";
export const playsInChromeEdge = "Plays in Chrome, Edge, Firefox and VLC, but not in Safari or QuickTime.";
export const dither = "Dither";
export const samplesPerPixel = "Samples per pixel";
export const photosBothLeavesFade = "The photos of both leaves fade into each other inside the outline";
export const withPhotos = "With the photos";
export const inCornerEachFrame = "In the corner of each frame";
export const captionWithTimeAnd = "Caption with time and verdict";
export const locusWithPathSmall = "The locus with the path, small, in a corner of each frame";
export const insetPositionOnLocus = "Inset: position on the locus";
export const numbersToExport = "Numbers to export";
export const from = "From";
export const all = "All";
export const smallFile = "A small file.";
export const aboutBytes = (size: string) => `about ${size}`;
export const tooLargeToReopen = "too large to reopen here";
export const aboutTime = (time: string) => `about ${time} on this device`;

export const size = "Size";
export const width = "Width";
export const height = "Height";

export const thereNoPictureAt = "There is no picture at that moment. Choose another.";

export const exportFailed = (problem: string) => `The export failed: ${problem}`;
export const thereNoNumbersTo = "There are no numbers to export.";

export const everywhere = "Everywhere";

export const savePicture = "Save the picture";
export const drawnAgainAtThis = "Drawn again at this size, complete and sharp.";
export const picture = "Picture of";
export const steps = "Steps";
export const smoothEdgesInAbout = "Smooth edges, in about four times the time";
export const ifYouOpenPicture = "If you open the picture in Frond, its document opens";
export const includeLinkInPicture = "Include the link in the picture";
export const picture2 = "Picture";
export const progressPicture = "Progress of the picture";
export const saveAsPng = "Save as PNG";
export const asOnStage = "As on the stage";
export const stepByStep = "Step by step";
export const fullHd19201080 = "Full HD, 1920 × 1080";
export const square20482048 = "Square, 2048 × 2048";
export const poster57938192 = "Poster, 5793 × 8192";
export const largest81928192 = "Largest, 8192 × 8192";
export const pictureFailed = (problem: string) => `The picture could not be saved: ${problem}`;

export const eachSide = (least: number, most: number) => `Each side must have ${least} to ${most} pixels.`;
export const thisCanSavedWith = "This can be saved with at most 4096 × 4096 pixels. Choose a smaller size.";
export const pictureSize = (width: number, height: number, size: string) =>
  `${width} × ${height} pixels · about ${size}`;

export const filmEndsBeforeBegins = "The film ends before it begins. Choose a later end.";
export const gifFps = (most: number) => `A GIF shows at most ${most} frames per second. Choose fewer.`;
export const chooseFps = (least: number, most: number) => `Choose ${least} to ${most} frames per second.`;
export const chooseHold = (most: number) => `Pause for 0 to ${most} s at each end.`;
export const tooManyFrames = (count: string, most: string, seconds: number) =>
  `${count} frames are too many; the limit is ${most}. Choose fewer frames per second, or at most ${seconds} s.`;
export const evenSides = (least: number, most: string) =>
  `Each side must have ${least} to ${most} pixels, an even number.`;
export const thisSizeTooLarge =
  "This size is too large for 4 × 4 samples per pixel. Choose 2 × 2, or a smaller size.";
export const tooLarge = (size: string) =>
  `The film would have about ${size}, more than a browser can hold. Choose a smaller size or fewer frames.`;
export const moment = "a moment";

export const boundingRectangle = "Bounding rectangle";
export const convexHull = "Convex hull";
export const square = "Square";
export const triangle = "Triangle";
export const leaf = "Leaf";
export const point = "Point";

export const small480270 = "Small, 480 × 270";
export const medium854480 = "Medium, 854 × 480";
export const hd1280720 = "HD, 1280 × 720";
export const square720720 = "Square, 720 × 720";
export const portrait7201280 = "Portrait, 720 × 1280";

export const thisBrowserCouldNot = "This browser could not create a canvas.";

export const withoutAttractor = (count: number) =>
  `${counted(count, "moment has", "moments have")} no attractor. The film repeats the frame before.`;
export const framesDone = (done: string, count: string) => `${done} of ${count} frames`;
export const framesDoneLeft = (done: string, count: string, left: string) =>
  `${done} of ${count} frames, about ${left} left`;
export const framesAndLength = (count: number, seconds: string) =>
  `${counted(count, "frame", "frames")}, ${seconds} s`;
export const loopOf = (frames: string, loop: string) => `${frames}, ${loop}`;
export const to = "To";
export const asOnStageLarger = "As on the stage, larger";
