// Starts `lag lsp` and shows what it makes: results in editors, moving pages beside the text.
import * as path from "node:path";
import * as vscode from "vscode";
import {
  LanguageClient,
  type LanguageClientOptions,
  type ServerOptions,
  type ShowDocumentParams,
  type ShowDocumentRequest,
  type ShowDocumentResult,
} from "vscode-languageclient/node";

const MODELS = ["run", "show", "derive", "verify"] as const;
const CLASS = vscode.SymbolKind.Class;

let client: LanguageClient | undefined;
const panels = new Map<string, vscode.WebviewPanel>();

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  for (const word of MODELS) {
    context.subscriptions.push(
      vscode.commands.registerCommand(`lagdsl.${word}Model`, () => command(word)),
    );
  }
  context.subscriptions.push(
    vscode.commands.registerCommand("lagdsl.restart", restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("lagdsl.command")) {
        void restart();
      }
    }),
  );
  await start();
}

export async function deactivate(): Promise<void> {
  await client?.stop();
}

async function start(): Promise<void> {
  const server: ServerOptions = { command: compiler(), args: ["lsp"] };
  const options: LanguageClientOptions = {
    documentSelector: [{ language: "lag" }],
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.lag") },
    middleware: { window: { showDocument } },
  };
  client = new LanguageClient("lagdsl", "Lag", server, options);
  try {
    await client.start();
  } catch {
    const open = "Open the setting";
    const chosen = await vscode.window.showErrorMessage(
      `\`${compiler()} lsp\` does not start. Run pip install '.[lsp]' in the folder of the sources of lagdsl, or set lagdsl.command.`,
      open,
    );
    if (chosen === open) {
      await vscode.commands.executeCommand("workbench.action.openSettings", "lagdsl.command");
    }
  }
}

async function restart(): Promise<void> {
  if (client?.isRunning()) {
    await client.stop();
  }
  await client?.dispose();
  await start();
}

/** The setting; a relative path is one of the first folder. */
function compiler(): string {
  const given = vscode.workspace.getConfiguration("lagdsl").get<string>("command", "lag");
  const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
  const isPath = given.includes("/") || given.includes("\\");
  return isPath && !path.isAbsolute(given) && folder !== undefined ? path.join(folder, given) : given;
}

/** Runs a command of the server on the model at the cursor, or on the last one of the text. */
async function command(word: (typeof MODELS)[number]): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  if (editor === undefined || editor.document.languageId !== "lag") {
    return;
  }
  const uri = editor.document.uri;
  const symbols = await vscode.commands.executeCommand<vscode.DocumentSymbol[] | undefined>(
    "vscode.executeDocumentSymbolProvider",
    uri,
  );
  const models = (symbols ?? []).filter((symbol) => symbol.kind === CLASS);
  const model = models.find((symbol) => symbol.range.contains(editor.selection.active)) ?? models.at(-1);
  if (model === undefined) {
    await vscode.window.showInformationMessage("The text has no model.");
    return;
  }
  await vscode.commands.executeCommand(`lagdsl.${word}`, uri.toString(), model.name);
}

/** Moving pages stand beside the text; everything else opens as the editor does it. */
async function showDocument(
  params: ShowDocumentParams,
  token: vscode.CancellationToken,
  next: ShowDocumentRequest.HandlerSignature,
): Promise<ShowDocumentResult> {
  if (!params.uri.startsWith("http://127.0.0.1:")) {
    const opened = await next(params, token);
    return "success" in opened ? opened : { success: false };
  }
  const known = panels.get(params.uri);
  if (known !== undefined) {
    known.reveal(undefined, true);
    return { success: true };
  }
  const address = await vscode.env.asExternalUri(vscode.Uri.parse(params.uri, true));
  const panel = vscode.window.createWebviewPanel(
    "lagdsl.page",
    "Lag",
    { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
    { enableScripts: true, retainContextWhenHidden: true },
  );
  panel.webview.html = framed(address.toString(true));
  panel.onDidDispose(() => panels.delete(params.uri));
  panels.set(params.uri, panel);
  return { success: true };
}

function framed(address: string): string {
  const url = new URL(address);
  const source = url.href.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);
  return `<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; frame-src ${url.origin}">
<style>html,body,iframe{margin:0;padding:0;border:0;width:100%;height:100vh;display:block}</style></head>
<body><iframe title="Lag" src="${source}"></iframe></body></html>`;
}
