/** What the sheets that share and publish a document say. */

export const thisMoment = "This moment";
export const beginning = "The beginning";
export const playOnce = "Play once";
export const playsThereAndBack = "Plays there and back, then rests at this moment";
export const loop = "Loop";
export const untilSomeonePauses = "Until someone pauses it";
export const paused = "Paused";
export const untilSomeonePressesPlay = "Until someone presses play";
export const readersTheme = "The reader’s theme";
export const lightOrDarkAs = "Light or dark, as each reader has chosen";
export const dark = "Dark";
export const light = "Light";
export const sameBackgroundAndColours = "The same background and colours for everyone";
export const share = "Share";
export const noLink =
  "This document does not fit into a link. Simplify it, or rescale very large or very small parts.";
export const link = "Link";
export const copy = "Copy";
export const startAt = "Start at";
export const whenOpened = "When opened";
export const theme = "Theme";
export const send = "Send …";
export const forYourOwnWeb = "For your own web page:";
export const iframeForPageBlog = "An iframe for a page, blog or slide: the picture with a slider";
export const embedCode = "Embed code";
export const copyEmbedCode = "Copy embed code";
export const twoLinesHtmlScript = "Two lines of HTML: a script, and the element that shows the morph";
export const element = "Element";
export const copyElement = "Copy element";
export const readyMadeWebPage =
  "A ready-made web page (ZIP) with the live morph, a preview image and everything it needs";
export const publish = "Publish …";
export const moreOptions = "More options …";
export const linkHasChangedCopy = "The link has changed. Copy it again.";
export const linkContainsDeformationBut =
  "The link contains the deformation, but not the photo: that stays on this device.";
export const anyoneWithLinkSees = "Anyone with the link sees the same picture.";
export const anyoneWithLinkSeesThis = "Anyone with the link sees this, in their own light or dark theme.";
export const anyoneWithLinkSeesSame =
  "Anyone with the link sees the same shapes, on the background of their own theme.";
export const wasCopied = (what: string) => `${what} copied.`;
export const allowClipboard = "allow this page to use the clipboard, then try again.";
export const copyYourself = "select the link and copy it yourself.";
export const copyingBlocked = (instead: string | number) => `The browser blocked copying: ${instead}`;
export const frond = "Frond";
export const sharingFailed = (problem: string) => `Sharing failed: ${problem}`;

export const enterAddressBeginsWith =
  "Enter an address that begins with https:// and ends with a folder, such as https://example.org/fern/.";
export const liveFractalMadeWith = "A live fractal, made with Frond.";
export const fractal = "A fractal";
export const savedUnpackZipAnd = "Saved. Unpack the ZIP and upload the folder to your web host.";
export const publishingFailed = (problem: string) => `Publishing failed: ${problem}`;
export const publish2 = "Publish";
export const readyMadeWebPageZip =
  "A ready-made web page (ZIP) with the live morph, a preview image and everything it needs.";
export const title = "Title";
export const description = "Description";
export const addressOptional = "Address (optional)";
export const pagesFullAddressMessengers = "The page’s full address. Messengers need it to show a preview.";
export const film = "Film";
export const none = "None";
export const cancel = "Cancel";
export const saveFolderZip = "Save the folder (ZIP)";
export const fractalInSpace = "A fractal in space";
export const fractalCurve = "A fractal curve";
export const to = (name: string, name2: string) => `${name} to ${name2}`;

export const folderFiles = (film: string) => `index.html, picture.png, ${film}frond-view.js and licenses.txt`;
export const uploadThisFolderTo = (files: string) =>
  `Upload this folder (${files}) to any static web host. No server program is needed.`;
export const toSeeWithoutHost = "To see it without a host, double-click index.html.";
export const messengersShowPreviewOnly =
  "Messengers show a preview only if index.html contains its own address. To add it, publish again and fill in “Address”.";
export const madeFor = (home: string) =>
  `This page is made for ${home}. It also works elsewhere, but previews then point to that address.`;

export const loadingRenderer = "Loading the renderer …";
export const renderingPreview = "Rendering the preview …";
export const renderingFilm = (done: number, count: number) => `Rendering the film: frame ${done} of ${count}`;
export const couldNotDownloadedTry = (name: string) =>
  `${name} could not be downloaded. Try again when you are online.`;
