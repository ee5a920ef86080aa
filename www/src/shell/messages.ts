/** What the header, the frame of the page and its notices say. */

export const partOfThePath = (t: string) => `${t}% of the path`;
export const turnAndMove = (u: string, v: string) => `turn u ${u}, move v ${v}`;
export const partOutOfView = "part is out of view";
export const noWorkers = "no workers";
export const fitToStage = "Fit to the stage";

export const savingFailed = (problem: string) => `Saving failed: ${problem}`;

export const backToClassSheet = "Back to the class sheet";
export const figuresTitle = "Figures · ";
export const learnTitle = "Learn · ";
export const figuresFailed = (problem: string) => `The figures could not be loaded: ${problem}`;

export const fileCouldNotRead = "The file could not be read. Drop it onto the page instead.";
export const newerVersionFrondAvailable =
  "A newer version of Frond is available. Your work stays in the address.";
export const update = "Update";

export const somethingWentWrong = (problem: string) => `Something went wrong: ${problem}`;
export const frondCouldNotStart = "Frond could not start";
export const thisBrowserDoesNot =
  "This browser does not support WebAssembly, or it is turned off. Use a current Firefox, Chrome, Edge or Safari.";
export const reloadPageIfDoes =
  "Reload the page. If that does not help, try a current Firefox, Chrome, Edge or Safari.";
export const reload = "Reload";

export const themeSystem = "Theme: system";
export const themeLight = "Theme: light";
export const themeDark = "Theme: dark";
export const skipTo = (destination: string) => `Skip to the ${destination}`;
export const places = "Places";
export const learn = "Learn";
export const figures = "Figures";
export const changeTheme = (theme: string) => `${theme}; change`;
export const share = "Share";
export const more = "More";
export const openFileItem = "Open a file …";
export const helpItem = "Help …";
export const recentItem = "Recent …";
export const saveAsPng = "Save as PNG";
export const print = "Print …";
export const pictureAnySize = "Picture of any size …";
export const mapsAsText = "Maps as text …";
export const meshFor3D = "Mesh for 3-D printing …";
export const filmItem = "Film …";
export const filmMade = (percent: number) => `Film, ${percent}% rendered`;
export const saveAs = (format: string) => `Save as ${format}`;
export const undo = "Undo";
export const redo = "Redo";
export const openFile = "Open a file";
export const recent = "Recent";
export const save = "Save";
export const help = "Help";
export const toolOrPage = "Tool or page";

export const thisPageHasNo = "This page has no picture.";

export const picture = "Picture";
