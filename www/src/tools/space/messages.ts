/** What the tool Space says. */
import { plural } from "#format/plural";

export const object = "The object";
export const startToDeform = "Start to deform";
export const latticeAround = (name: string) =>
  `Adds a lattice of handles around ${name}. When you pull a handle, every part follows at every scale, in its own place.`;
export const deform = "Deform it";
export const lattice = "Lattice";
export const resetAll = "Reset all";
export const handlesAlongEachAxis = "Handles along each axis";
export const handlesAlong = (axis: string) => `Handles along ${axis}`;
export const howPartsRespond = "How the parts respond";
export const locality = "Locality";
export const kb = "kb";
export const localityOf = (kb: string, ke: string) => `${kb} of ${ke}`;
export const scatteredEveryPartResponds = "scattered: every part responds";
export const roughness = "Roughness";
export const text = "δ";
export const detail = "Detail";
export const ke = "ke";
export const scales = (count: string) => `${count} scales`;
export const fullShape = "the full shape";
export const smallestParts = "the smallest parts";
export const upInPartWhat = "Up in a part is what its map makes of up";
export const displacementsRotateWithPieces = "Displacements rotate with the pieces";
export const piecesMeetInCorners =
  "Its pieces meet in corners. Neighbours stay joined there, and nothing tears.";
export const piecesShareNoCorners =
  "Its pieces share no corners that could join them. The formula applies as it is, and the shape tears where the codes of neighbours differ.";
export const selectedHandle = "Selected handle";
export const movedBy = (handle: string) => `${handle}, moved by`;
export const movedAlong = (axis: string) => `Moved along ${axis}`;
export const inFractionsLongestSide =
  "In fractions of the longest side of the lattice, along the original axes of the object.";
export const deformation = "The deformation";
export const removeDeformation = "Remove deformation";

export const inOnePiece = "In one piece";
export const why = "Why";

export const arrowKeysMoveHandle =
  "Arrow keys move the handle in the plane of the picture, by four pixels, with Shift by forty. ";
export const pageUpAndPage =
  "Page Up and Page Down move it away and closer. The brackets go to the handle before or after, Delete resets it.";
export const latticeOf = (sizes: string) => `Lattice of ${sizes} handles`;

export const liftCorner = "Lift a corner";
export const oneCornerLatticePulled = "One corner of the lattice is pulled out";
export const twist = "Twist";
export const eachLayerRotatedUpper = "Each layer is rotated, the upper ones more";
export const lean = "Lean";
export const upperLayersMoveTo = "The upper layers move to the side";
export const swell = "Swell";
export const centreEachFacePushed = "The centre of each face is pushed out";
export const insideOut = "Inside out";
export const eachControlPointMoves = "Each control point moves to the opposite one";
export const handle = (place: string) => `Handle ${place}`;

export const continuousImageConnectedShape =
  "A continuous image of a connected shape is connected, so the verdict also applies to the deformed shape.";
export const everyTermThisDeformation =
  "Every term of this deformation is averaged where cells of neighbouring pieces share corners, and continues between them without a jump. So the whole deformation is continuous. Corners count as shared if they agree to a billionth of the shape’s size.";
export const withoutShufflingDeformationPolynomial =
  "Without shuffling, the deformation is a polynomial of the position, and so continuous.";
export const wherePiecesMeetPoint =
  "Where pieces meet, a point has several addresses, and the shuffle may take each of them to a different place. The shape tears there unless these places agree. Keeping it together everywhere is what Fujimoto and others call a connected IST, and leave open. Frond does so where pieces meet in corners. If the locality equals the detail, or there is no roughness, nothing is shuffled and nothing tears.";
export const latticeMovesNoTwo =
  "The lattice moves no two points towards each other by more than a part of their distance, so no two points coincide. The deformation joins nothing, and the verdict applies both ways.";
export const latticeAtRestSo = "The lattice is at rest, so the shape is not deformed.";
export const allLatticeMovesAlike = "All of the lattice moves alike, so the shape is only moved.";
export const notKnown = "Not known";
export const codesMayTear = "codes may tear it";
export const asWithoutDeformation = "as without the deformation";
export const withoutDeformationTearsNothing = "without the deformation, which tears nothing";
export const notProvedBefore = (why: string) =>
  `${why} It was not proved that the undeformed shape is in one piece, so it is not proved for this one.`;
export const inPiecesWhenUndeformed = "in pieces when undeformed, but a fold may join them";
export const foldMayJoin = (why: string) =>
  `${why} It tears nothing more, but where it folds the shape over, separate pieces may meet.`;

export const handle2 = "Handle";
export const handleMovedBy = (handle: string, parts: string) => `${handle}, moved by ${parts} percent`;

export const dragMode = "Drag mode";
export const viewpoints = "Viewpoints";
export const nextOrPreviousDrag = "Next or previous drag mode: look around; rotate, move, scale the object";
export const holdWhileDraggingPan = "Hold while dragging: pan the view";
export const withPictureFocused = "With the picture focused";
export const asDragModeSays = "As the drag mode says; with Shift, pan the view";
export const zoomInZoomOut = "Zoom in, zoom out";
export const flyForwardLeftBack = "Fly forward, left, back, right (Shift: finer)";
export const flyDownUp = "Fly down, up";
export const decreaseOrIncreaseAngle = "Decrease or increase the angle of view";
export const showAll = "Show all";
export const fromOrigin = "From the origin";
export const setKeyframe = "Set a keyframe";
export const time = "Time";
export const keyframeFocused = "Keyframe, focused";
export const moveBy01 = "Move it by 0.1 s (Shift: finer, Alt: coarser)";
export const goThere = "Go there";
export const toNextOne = "To the next one";
export const deleteLabel = "Delete it";

export const space = "Space";
export const frondRotateAndMove = "Frond: rotate and move fractals in space";
export const shapesMorphAndLight = "Shapes, morph and light";
export const spaceCouldNotLoaded = "Space could not be loaded";

export const noAnimationYetSo =
  "No animation yet, so there is nothing to film. Set two keyframes, or start with a ready-made flight.";
export const flyThrough = "Fly through";
export const thereNothingToDraw = "There is nothing to draw yet.";
export const everyFrame = "Every frame";
export const parametersEachFrameFor = "The parameters of each frame, for other programs and for Frond";
export const shapesAndKeyframes = "Shapes and keyframes";
export const smallFileForFrond = "A small file for Frond";
export const shapesLightAndKeyframes =
  "The shapes, the light and the keyframes. Frond can open the file again: More options for time, Open a saved animation.";
export const forEachFrameTime =
  "For each frame its time, the view, and the parameters of every object: 12 numbers per map, the rows of its matrix and then its translation. Frond can open the file again, with its keyframes.";

export const shape = "Shape";
export const objectsTheirParametersAnd = "Objects, their parameters and transformations";
export const deform2 = "Deform";
export const latticeDeformsObjectAt = "A lattice that deforms the object at every scale";
export const morph = "Morph";
export const anotherShapeFirstObject = "Another shape that the first object turns into";
export const light = "Light";
export const lightColoursAndView = "Light, colours, and the view in numbers";
export const keyframesAndFilms = "Keyframes and films";
export const files = "Files";
export const panel = "Panel";

export const byMap = "By map";
export const eachMapHasOwn = "Each map has its own colour";
export const byHeight = "By height";
export const fromLowestPointTo = "From the lowest point to the highest";
export const lightAndColour = "Light and colour";
export const resetLightAndColours = "Reset light and colours";
export const reset = "Reset";
export const colour = "Colour";
export const lightDirection = "Light direction";
export const frontalLight = "Frontal light";
export const fromViewer = "from the viewer";
export const ambientLight = "Ambient light";
export const shadowsBlack = "shadows are black";
export const ambientOcclusion = "Ambient occlusion";
export const none = "none";
export const fog = "Fog";
export const noFog = "no fog";
export const shadowsAndMaterial = "Shadows and material";
export const compressesBrightTonesAs = "Compresses bright tones, as film does, instead of clipping them";
export const filmicTones = "Filmic tones";
export const shadowsAndAmbientOcclusion = "Shadows and ambient occlusion appear when the picture is at rest.";
export const shadows = "Shadows";
export const noShadowsCast = "no shadows are cast";
export const softnessShadows = "Softness of shadows";
export const sharpEdges = "sharp edges";
export const skyLight = "Sky light";
export const uniformWhiteLight = "uniform white light";
export const blueSkyWarmSun = "blue sky, warm sun";
export const gloss = "Gloss";
export const likeLightPaper = "Like light paper";
export const dark = "Dark";
export const likeNight = "Like the night";
export const custom = "Custom";
export const yourOwnColour = "Your own colour";
export const page = "Page";
export const backgroundViewersPage = "The background of the viewer’s page";
export const partPictureLinkAnd = "It is part of the picture, its link and saved files.";
export const anyoneWithLinkSees =
  "Anyone with the link sees the picture on the background of their own page, light or dark. A saved PNG is transparent; a film uses the background of this page.";
export const background = "Background";
export const backgroundColour = "Background colour";

export const rotationToSide = "Rotation to the side";
export const tiltUpwards = "Tilt upwards";
export const view = "View";
export const resetView = "Reset the view";
export const angleView = "Angle of view";
export const degreesHigh = (degrees: number) => `${degrees} degrees from top to bottom`;
export const farAndFlat = "far and flat";
export const nearAndWide = "near and wide";
export const looksAt = "Looks at";
export const looksAtOf = (axis: string) => `Looks at, ${axis}`;
export const from = "From";
export const distance = "Distance";
export const eyeAt = (place: string) => `The eye is at ${place}`;
export const draggingTurnsHeadOtherwise = "Dragging turns the head. Otherwise it orbits the target";
export const keepEyeInPlace = "Keep the eye in place";

export const fromAbove = "from above";
export const fromBelow = "from below";
export const fromAboveOf = (degrees: number, side: string) => `from above, ${degrees}° to the ${side}`;
export const fromSide = (side: string) => `from the ${side}`;
export const fromBelowOf = (degrees: number, side: string) => `from below, ${degrees}° to the ${side}`;
export const frontPercent = (percent: number) => `${percent} % on the viewer’s side`;

export const for3DPrinters = "For 3-D printers: only triangles, in millimetres";
export const withColoursAndNormals = "With colours and normals, in millimetres";
export const forPagesAndScenes = "For pages and scenes (.glb): with colours and a material, in metres";
export const meshFor3D = "Mesh for 3-D printing";
export const stageAtThisMoment =
  "The stage at this moment, as one watertight surface. Every piece is refined until it is smaller than a sample.";
export const thereNothingToExport = "There is nothing to export yet.";
export const format = "Format";
export const longestSide = "Longest side";
export const thinnestWall = "Thinnest wall";
export const resolution = "Resolution";
export const resolutionNumberSamplesAlong =
  "Resolution is the number of samples along the longest side: the higher, the finer the detail. Parts thinner than the wall, such as a curve or a sheet, are thickened. Closed hollows are filled.";
export const measuring = "Measuring …";
export const progressMesh = "Progress of the mesh";
export const cancel = "Cancel";
export const saveMesh = "Save the mesh";
export const meshNotSaved = (problem: string) => `The mesh could not be saved: ${problem}`;

export const tooMuchMemory = (most: number) =>
  `This needs more memory than available. Choose a resolution of ${most} or less.`;
export const tooManyTriangles = (count: string) =>
  `The mesh would have about ${count} triangles; the limit is 6 million. Choose a lower resolution or thicker walls.`;
export const meshSize = (
  sides: string,
  about: string,
  triangles: string,
  about2: string | number,
  bytes: string,
) => `${sides} mm · ${about}${triangles} triangles · ${about2}${bytes}`;
export const wallsAre = (thickness: string) =>
  `At this resolution the walls are ${thickness} mm thick. A higher resolution makes thinner walls.`;
export const inParts = (count: number) =>
  `The mesh is in ${count} separate parts. Thicker walls may join them.`;
export const million = (count: string) => `${count} million`;

export const twoShapes = "The two shapes";
export const swapped = (a: string, b: string) => `Swapped: from ${a} to ${b}.`;
export const chooseShape = "Choose a shape …";
export const custom2 = ", custom";
export const shapeB = "Shape B";
export const firstBecomes = (name: string) => `The first object turns into ${name}.`;

export const byRotation = "By rotation";
export const polarRotationsAndStretches = "Polar: rotations and stretches of each map are blended separately";
export const entryByEntry = "Entry by entry";
export const linearMapsMayFlattened = "Linear: maps may be flattened on the path";
export const howMapsBecomeMaps = "How maps become maps";
export const blendMaps = "Blend maps";
export const pairing = "Pairing";
export const nearest = "nearest";
export const piecesTravelRotateAnd = "Pieces travel, rotate and stretch as little as possible";
export const byNumber = "by number";
export const hereThisAlsoNearest = "Here this is also the nearest pairing";
export const firstBecomesFirstAnd = "The first becomes the first, and so on";
export const custom3 = "custom";
export const mapByMap = "Map by map";
export const mapBecomes = (number: number) => `Map ${number} becomes`;
export const ifTwoMapsChange = "If two maps change partners, they swap them.";
export const otherObjectStaysAs = "The other object stays as it is.";
export const othersStay = (count: number) => `The other ${count} objects stay as they are.`;

export const positionOnPath = "Position on the path";
export const timeAlongPath = "Time along the path";
export const pauseMorph = "Pause the morph";
export const playMorph = "Play the morph";
export const timeAlongPathIn = "Time along the path in percent";
export const turnsAndStretches = (u: string) => `${u} rotates and stretches,`;
export const moves = (v: string) => `${v} moves`;
export const timelineControlsThisWhat =
  "The timeline controls this. What you set here becomes a keyframe at this moment, and plays below.";

export const unequalMaps = (a: string, aMaps: string | number, b: string, bMaps: string | number) =>
  `${a} has ${aMaps} maps and ${b} has ${bMaps}, but each map must become one. Choose another shape B.`;
export const startMorph = "Start a morph";
export const aboutMorph = (others: string) =>
  `The first object can turn into another shape with as many maps. Frond shows the locus and searches for a path on which the shape stays in one piece. ${others}`;
export const tetrahedronAndCurledDragon =
  "A tetrahedron and a curled dragon replace the scene. Undo brings it back";
export const tetrahedronTurnsIntoDragon =
  "The tetrahedron turns into a dragon. Frond is searching for a path.";
export const tetrahedronToDragonIn = "Tetrahedron to the dragon in space";
export const morph2 = "The morph";
export const firstObjectStaysAs = "The first object stays as it is at the start";
export const morphRemoved = "The morph is removed.";
export const removeMorph = "Remove the morph";

export const orDoubleClickLocus = "or double-click the locus";
export const searchForPath = "Search for a path";
export const frondSearchingForPath = "Frond is searching for a path on which it stays in one piece.";
export const frondSearchingForBetter = "Frond is searching for a better path.";
export const searchAgain = "Search again";
export const youEndedSearchThis = "You ended the search. This is the best path so far.";
export const youEndedSearchBefore = "You ended the search before it found a path, so this one is straight.";
export const orOtherPairing = (best: string) => `${best} Another pairing or other shapes may have one.`;

export const locusOverUTo =
  "Locus over u, to the right, and v, upwards, from −1 to 2: pale where the shape stays in one piece, dark where it is in pieces. ";
export const handlesMovePath = "Its handles move the path.";

export const objectThisSceneUntransformed = "An object of this scene, untransformed.";
export const copyItself = "A copy of itself";
export const editFirstShapeAfterwards =
  "Edit the first shape afterwards, under Shape. The morph then leads from one to the other.";
export const mapCount = (count: number) => `${count} maps`;
export const needsSameMaps = (counts: string) =>
  `Each map becomes a map, so you cannot choose a shape with ${counts} maps.`;
export const hasMaps = (name: string, maps: string, rest: string) => `${name} has ${maps}. ${rest}`;
export const noneHasAsMany = (name: string, maps: string, rest: string) =>
  `${name} has ${maps}, and no other shape in the gallery has as many. ${rest}`;
export const orLast = (counts: string, last: string | number) => `${counts} or ${last}`;

export const mostWaypoints = (most: number) => `A path has at most ${most} waypoints.`;
export const waypointAdded = (number: number, count: number, point: string) =>
  `Waypoint ${number} of ${count} added at ${point}.`;
export const waypointRemoved = (number: number, count: number) =>
  `Waypoint ${number} removed, ${count} left.`;

export const youLookingAroundReturn = "You are looking around. Return to the flight";
export const backToFlight = "Back to the flight";
export const objectNumber = (number: number) => `object ${number}`;

export const shapesInSpaceArrow =
  "The shapes in space. Arrow keys rotate the view, or the object if the drag mode says so; with Shift they pan the view. Plus and minus change the distance, comma and full stop the angle of view, W, A, S, D, Q and E fly, 0 shows all.";

export const look = "Look";
export const dragToLookAround = "Drag to look around; the shapes stay";
export const rotate = "Rotate";
export const dragToRotateObject = "Drag to rotate the object, by its parameters";
export const move = "Move";
export const dragToMoveObject = "Drag to move the object, by its parameters";
export const scale = "Scale";
export const dragToScaleObject = "Drag to scale the object, by its parameters";
export const dragModeForView = "Drag mode, for the view or the selected object";
export const eyeAtOriginAs = "The eye at the origin, as in the papers";
export const origin = "Origin";
export const asInPapersEye = "As in the papers: the eye stays at (0, 0, 0), and dragging turns it there";
export const eyeAtOrigin = "Eye at the origin";

export const objectUnchanged = (problem: string) => `The object is unchanged: ${problem}`;

export const thisPageHasNo = "This page has no picture of space.";

export const anotherPictureWasRequested = "Another picture was requested.";
export const graphicsCardCannotDraw =
  "The graphics card cannot draw a picture of this size. Make the window smaller.";

export const thereNoPictureYet = "There is no picture yet.";
export const deviceLost = (reason: string) =>
  `The graphics card stopped responding (${reason}). Frond has drawn the picture again.`;
export const notComplete = (problem: string) => `The complete picture could not be drawn: ${problem}`;

export const preparing = "Preparing …";
export const completePicture = "Complete picture";
export const completePictureSmoothing = "Complete picture, smoothing …";
export const coarsePicture = "Coarse picture";
export const pointsCompleting = (points: string) => `${points} points, completing …`;
export const drawing = "Drawing …";
export const objectsOf = (count: number, words: string) => `${count} objects, ${words}`;
export const turns = "Turns";
export const moves2 = "Moves";
export const scales2 = "Scales";
export const everythingBehindEye = "Everything is behind the eye.";
export const nothingInView = "Nothing is in view.";
export const eyeInside = (name: string) => `The eye is inside ${name}.`;
export const eyeInsideSeveral = (count: number) => `The eye is inside ${count} objects.`;

export const object2 = "Object";

export const undeformed =
  "The maps, the shadow on a plane and a mesh for printing belong to the shape without the deformation.";
export const undeformedKeyed =
  "The maps, the shadow on a plane and a mesh for printing belong to the shape without the deformation. With a timeline, each keyframe stores where the handles are; all other settings apply to the whole time.";
export const reflects = (maps: readonly (string | number)[]) =>
  plural(maps.length, {
    one: `Map ${maps[0]} is mirrored in one shape only, so it is flattened on the path.`,
    other: `Maps ${maps.join(", ")} are mirrored in one shape only, so they are flattened on the path.`,
  });
export const lightAndColours = " light and colours";
export const theView = " the view";
export const colourSource = "Colour by";
export const pairEach = "Which map each becomes";
