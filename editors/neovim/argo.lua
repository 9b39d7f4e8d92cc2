-- ARGO in Neovim, 0.7 or newer. Put this file into ~/.config/nvim/plugin/, with the path of argo.jar.
local jar = vim.g.argo_jar or vim.fn.expand("~/argo/argo.jar")

-- Colours, as far as a person needs them; the server has all else.
local function colours()
  vim.cmd([[
    syntax clear
    syntax match agentspeakVariable /\<[A-Z_]\w*/
    syntax match agentspeakNumber /\<\d\+\(\.\d\+\)\?\>/
    syntax match agentspeakAction /\<argo\.\w\+\|\(\w\|)\)\@<!\.\l\w*/
    syntax match agentspeakGoal /[-+^]\?!!\?\l\w*\|[-+]?\l\w*/
    syntax match agentspeakOperator /<-\|:-\|[&|:;]/
    syntax keyword agentspeakKeyword not true false if else elif for while include begin end
    syntax keyword agentspeakKeyword MAS agents environment aslSourcePath agentArchClass agentClass
    syntax region agentspeakString start=/"/ skip=/\\./ end=/"\|$/
    syntax match agentspeakComment /\/\/.*/
    syntax region agentspeakComment start=/\/\*/ end=/\*\//
    highlight default link agentspeakVariable Identifier
    highlight default link agentspeakNumber Number
    highlight default link agentspeakAction Function
    highlight default link agentspeakGoal Special
    highlight default link agentspeakOperator Operator
    highlight default link agentspeakKeyword Keyword
    highlight default link agentspeakString String
    highlight default link agentspeakComment Comment
    setlocal commentstring=//\ %s
  ]])
end

local function keys(buffer)
  vim.bo[buffer].omnifunc = "v:lua.vim.lsp.omnifunc" -- Ctrl-X Ctrl-O completes
  local map = function(key, action) vim.keymap.set("n", key, action, { buffer = buffer }) end
  map("K", vim.lsp.buf.hover)
  map("gd", vim.lsp.buf.definition)
  map("gr", vim.lsp.buf.references)
  map("gO", vim.lsp.buf.document_symbol)
  map("<F2>", vim.lsp.buf.rename)
  map("<F3>", vim.lsp.buf.format or vim.lsp.buf.formatting)
end

local client -- one server for all files

local function attach(buffer)
  if not client or vim.lsp.client_is_stopped(client) then
    client = vim.lsp.start_client({
      name = "argo",
      cmd = { "java", "-XX:+UseSerialGC", "-Xmx512m", "-jar", jar, "lsp" },
      root_dir = vim.fn.getcwd(),
    })
  end
  vim.lsp.buf_attach_client(buffer, client)
  keys(buffer)
end

-- The debugger, if nvim-dap is there: start agents with argo_debug=4711, then :lua require("dap").continue()
local function debugger()
  local there, dap = pcall(require, "dap")
  if not there or dap.adapters.argo then return end
  dap.adapters.argo = function(attach_to, config) attach_to({ type = "server", host = "127.0.0.1", port = config.port }) end
  dap.configurations.agentspeak = { { type = "argo", request = "attach", name = "Attach to agents", port = 4711 } }
end

local group = vim.api.nvim_create_augroup("argo", {})
for pattern, language in pairs({ ["*.asl"] = "agentspeak", ["*.mas2j"] = "mas2j" }) do
  vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, {
    group = group,
    pattern = pattern,
    callback = function(event)
      vim.bo[event.buf].filetype = language
      colours()
      debugger()
      attach(event.buf)
    end,
  })
end
vim.api.nvim_create_autocmd({ "BufRead", "BufNewFile" }, {
  group = group,
  pattern = { "*/filters/*.xml", "*/filters/*.json" },
  callback = function(event) attach(event.buf) end,
})
